from . import results as results
from ._load import DescriptionWarning as DescriptionWarning
from ._load import load as load
from ._robot import Robot as Robot

__version__: str
__all__ = ["DescriptionWarning", "Robot", "__version__", "load", "results"]
