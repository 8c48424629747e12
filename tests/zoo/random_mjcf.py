def write(folder, seed):
    raise NotImplementedError
