"""Other libraries: values, derivatives against those of the package, and against finite differences.

A library that is not installed is skipped, unless HOMOGEN_LIBRARIES names it.
"""

import shutil

import numpy as np
import pytest
from conftest import ROBOTS, library, robot, same, states

import homogen


@pytest.fixture(scope="module")
def arm():
    return robot("arm")


def central(function, argument, step=1e-5):
    """The derivative of a function by central differences, a column for each entry."""
    columns = []
    for k in range(argument.size):
        ahead, back = argument.copy(), argument.copy()
        ahead[k] += step
        back[k] -= step
        columns.append((np.asarray(function(ahead)) - np.asarray(function(back))) / (2 * step))
    return np.stack(columns, axis=-1)


def test_a_library_that_is_missing_is_named(arm, monkeypatch):
    from homogen import _library

    monkeypatch.setattr(_library.importlib, "import_module", lambda name: exec("raise ImportError(name)"))
    with pytest.raises(ImportError, match="robot.casadi needs casadi, which is not installed: pip install casadi"):
        robot("arm").casadi


# --- CasADi ---------------------------------------------------------------------------------------


def test_casadi_functions_are_those_of_the_robot(arm):
    casadi = library("casadi")
    q, qd, qdd = (array[0] for array in states(arm, ["q", "qd", "qdd"], 1, float))
    function = arm.casadi.inverse_dynamics
    assert isinstance(function, casadi.Function) and function.name_in() == ["q", "qd", "qdd"]
    assert np.allclose(function(q, qd, qdd).full().ravel(), arm.inverse_dynamics(q, qd, qdd), rtol=1e-12)
    jacobian = arm.casadi.of("spatial_jacobian", frame="link5", order="angular_first")
    assert np.allclose(jacobian(q).full(), arm.spatial_jacobian(q, frame="link5", order="angular_first"))
    assert np.allclose(arm.casadi.forward_kinematics(q).full(), arm.forward_kinematics(q))
    assert np.isclose(float(arm.casadi.kinetic_energy(q, qd)), arm.kinetic_energy(q, qd))
    dq, dqd = arm.casadi.inverse_dynamics_derivatives(q, qd, qdd)
    derivatives = arm.inverse_dynamics_derivatives(q, qd, qdd)
    assert np.allclose(dq.full(), derivatives.dq) and np.allclose(dqd.full(), derivatives.dqd)


def test_casadi_differentiates_to_the_generated_derivatives(arm):
    casadi = library("casadi")
    q, qd, tau = (array[0] for array in states(arm, ["q", "qd", "tau"], 1, float))
    x = [casadi.SX.sym(name, 7) for name in ("q", "qd", "tau")]
    found = casadi.jacobian(arm.casadi.forward_dynamics(*x), casadi.vertcat(*x))
    found = casadi.Function("j", x, [found])(q, qd, tau).full()
    wanted = np.concatenate(arm.forward_dynamics_derivatives(q, qd, tau), axis=-1)
    assert np.allclose(found, wanted, rtol=1e-9, atol=1e-9 * np.abs(wanted).max())
    difference = central(lambda q: arm.forward_dynamics(q, qd, tau), q)
    assert np.allclose(found[:, :7], difference, rtol=1e-5, atol=1e-5 * np.abs(difference).max())


def test_casadi_has_no_more_operations_than_the_program(arm):
    casadi = library("casadi")
    cost = arm.count("inverse_dynamics")["functions"]["inverse_dynamics"]
    operations = sum(cost[key] for key in ("mul", "add", "div", "sqrt", "sin", "cos", "neg"))
    function = arm.casadi.inverse_dynamics
    kinds = [function.instruction_id(k) for k in range(function.n_instructions())]
    # The others read arguments, load constants and store results.
    moves = (casadi.OP_CONST, casadi.OP_INPUT, casadi.OP_OUTPUT)
    assert sum(kind not in moves for kind in kinds) <= operations


def test_casadi_has_external_functions_with_generated_derivatives(arm):
    casadi = library("casadi")
    if shutil.which("gcc") is None:
        with pytest.raises(OSError, match="robot.casadi.external needs a C compiler"):
            arm.casadi.external("inverse_dynamics")
        return
    q, qd, qdd = (array[0] for array in states(arm, ["q", "qd", "qdd"], 1, float))
    x = [casadi.MX.sym(name, arm.NV) for name in ("q", "qd", "qdd")]
    found = []
    for function in (arm.casadi.external("inverse_dynamics", flags=["-O1", "-ffp-contract=off"]), arm.casadi.inverse_dynamics):
        work = casadi.sumsqr(function(*x))
        results = [casadi.jacobian(function(*x), x[0]), casadi.hessian(work, casadi.vertcat(*x))[0]]
        found.append([result.full() for result in casadi.Function("of", x, results)(q, qd, qdd)])
    for compiled, symbolic in zip(*found):
        assert np.allclose(compiled, symbolic, rtol=1e-11, atol=1e-11 * np.abs(symbolic).max())
    with pytest.raises(AttributeError, match="there is no function 'torque' for casadi"):
        arm.casadi.external("torque")


def test_casadi_takes_fields_and_wrenches():
    casadi = library("casadi")
    of = homogen.load(
        ROBOTS / "two_link.urdf", external=["fore"], friction={"elbow": 0.2}, fields={"load": "mass_of:fore", "down": "gravity"}
    )
    q, qd, qdd, actions = (array[0] for array in states(of, ["q", "qd", "qdd", "actions"], 1, float))
    of.load = 1.7
    function = of.casadi.inverse_dynamics
    assert function.name_in() == ["q", "qd", "qdd", "actions", "load", "down"]
    found = function(q, qd, qdd, actions, 1.7, of.down)
    assert np.allclose(found.full().ravel(), of.inverse_dynamics(q, qd, qdd, actions), rtol=1e-12)
    load = casadi.SX.sym("load")
    slope = casadi.jacobian(function(q, qd, qdd, actions, load, of.down), load)
    difference = of.inverse_dynamics(q, qd, qdd, actions)
    of.load = 2.7
    difference = of.inverse_dynamics(q, qd, qdd, actions) - difference
    assert np.allclose(casadi.Function("s", [load], [slope])(0).full().ravel(), difference)


# --- JAX ------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def jax():
    jax = library("jax")
    jax.config.update("jax_enable_x64", True)
    return jax


@pytest.mark.parametrize("case", ["arm", "external"])
def test_jax_has_the_derivatives_of_finite_differences_and_of_plain_python(jax, case):
    from homogen._jax import DERIVATIVES, _by_plain

    of = robot(case)
    for name in DERIVATIVES:
        operation = getattr(of.jax, name)
        given = [array[0] for array in states(of, getattr(of, name).parameters()[0], 1, float)]
        every = tuple(range(len(given)))
        wanted = jax.jacfwd(lambda *values: _by_plain(np.zeros(0), *values, operation=operation)[0], every)(*given)
        for derivative in (jax.jacfwd, jax.jacrev):
            for found, one in zip(derivative(operation, every)(*given), wanted, strict=True):
                assert np.allclose(found, one, rtol=1e-9, atol=1e-9), name
        for k, found in enumerate(wanted):
            flat = central(lambda x, k=k: operation(*given[:k], x.reshape(given[k].shape), *given[k + 1 :]), given[k].ravel())
            assert np.allclose(found.reshape(flat.shape), flat, rtol=1e-4, atol=1e-4 * (1 + np.abs(flat).max())), name


def test_jax_calls_compiled_code(jax, arm):
    q, qd, qdd = states(arm, ["q", "qd", "qdd"], 40, float)
    for count in (1, 40):
        arguments = [array[:count] for array in (q, qd, qdd)]
        assert same(np.asarray(arm.jax.inverse_dynamics(*arguments)), arm.inverse_dynamics(*arguments))
        assert same(np.asarray(jax.jit(arm.jax.forward_kinematics)(q[:count])), arm.forward_kinematics(q[:count]))
    assert arm.jax.gravity(q[:0]).shape == (0, 7)
    text = jax.jit(arm.jax.gravity).lower(q).as_text()
    assert "homogen" in text and "sine" not in text


@pytest.mark.parametrize("case", ["arm", "floating", "external", "loop"])
def test_jax_computes_what_the_package_does(jax, case):
    of = robot(case)
    names = ["inverse_dynamics", "mass_matrix", "forward_kinematics", "potential_energy", "inverse_dynamics_derivatives"]
    for name in [*names, *(["constraint_jacobian"] if case == "loop" else [])]:
        arguments = states(of, getattr(of, name).parameters()[0], 6, float)
        if name == "forward_kinematics" and of.tip is None:
            continue
        wanted, found = getattr(of, name)(*arguments), getattr(of.jax, name)(*arguments)
        assert type(found) is type(wanted) or not isinstance(wanted, tuple)
        several = isinstance(wanted, tuple)
        for one, other in zip(found if several else [found], wanted if several else [wanted]):
            assert one.shape == other.shape and np.allclose(one, other, rtol=1e-9, atol=1e-9), name


def test_jax_transforms_functions(jax, arm):
    q, qd, qdd = states(arm, ["q", "qd", "qdd"], 6, float)
    dynamics = arm.jax.inverse_dynamics
    wanted = arm.inverse_dynamics_derivatives(q, qd, qdd)
    for derivative in (jax.jacfwd, jax.jacrev):
        dq, dqd = jax.vmap(derivative(dynamics, (0, 1)))(q, qd, qdd)
        assert np.allclose(dq, wanted.dq, rtol=1e-9, atol=1e-9) and np.allclose(dqd, wanted.dqd, rtol=1e-9, atol=1e-9)
    energy = jax.jit(jax.grad(arm.jax.potential_energy))
    assert np.allclose(energy(q[0]), arm.gravity(q[0]))
    hessian = jax.hessian(arm.jax.potential_energy)(q[0])
    assert np.allclose(hessian, arm.gravity_derivative(q[0]))
    assert np.allclose(hessian, central(lambda q: arm.gravity(q), q[0]), atol=1e-6)
    assert np.allclose(dynamics(q[:, None], qd, qdd[0]), arm.inverse_dynamics(q[:, None], qd, qdd[0]))
    single = dynamics(*(array.astype(np.float32) for array in (q, qd, qdd)))
    assert single.dtype == np.float32
    with pytest.raises(ValueError, match=r"q has the shape \(6,\), and must have \(..., 7\)"):
        dynamics(q[0, :6], qd, qdd)
    with pytest.raises(TypeError, match="2 arguments"):
        dynamics(q, qd)


def test_jax_goes_back_without_matrices_of_derivatives(jax, arm):
    q, qd, qdd = states(arm, ["q", "qd", "qdd"], 6, float)
    for name in ("inverse_dynamics", "forward_dynamics"):
        function = getattr(arm.jax, name)

        def work(*given, function=function):
            return (function(*given) * qd).sum()

        # An argument without leading axes has the sum of all gradients.
        gradient = jax.grad(work, (0, 1, 2))
        found = gradient(q[0], qd, qdd)
        wanted = getattr(arm, f"{name}_vjp")(np.broadcast_to(q[0], q.shape), qd, qdd, qd)
        for one, other in zip(found, [wanted[0].sum(0), *wanted[1:]], strict=True):
            assert np.allclose(one, other, rtol=1e-9, atol=1e-9 * np.abs(other).max()), name
        assert "[6,7,7]" not in str(jax.make_jaxpr(gradient)(q, qd, qdd))
    hessian = arm.inverse_dynamics_hessian(q[0], qd[0], qdd[0], qd[1])

    def weighted(q):
        return arm.jax.inverse_dynamics(q, qd[0], qdd[0]) @ qd[1]

    for second in (jax.jacfwd(jax.jacrev(weighted)), jax.jacrev(jax.jacfwd(weighted)), jax.jacrev(jax.jacrev(weighted))):
        found = second(q[0])
        assert np.allclose(found, hessian[0], rtol=1e-9, atol=1e-9 * np.abs(hessian[0]).max())


def test_jax_goes_forward_without_matrices_of_derivatives(jax):
    for case in ("arm", "external"):
        of = robot(case)
        links = of._recipe.facts()["external"]
        names = ["q", "qd", "qdd", "actions"][: 4 if links else 3]
        values, tangents = (states(of, names, 6, float, seed) for seed in (0, 1))
        for name in ("inverse_dynamics", "forward_dynamics"):
            function = getattr(of.jax, name)
            found, change = jax.jvp(function, values, tangents)
            assert np.allclose(found, getattr(of, name)(*values))
            h = 1e-6
            ends = [getattr(of, name)(*(x + s * h * v for x, v in zip(values, tangents))) for s in (-1, 1)]
            assert np.allclose(change, (ends[1] - ends[0]) / (2 * h), atol=1e-6 * np.abs(change).max())
            along = jax.make_jaxpr(lambda values, tangents: jax.jvp(function, values, tangents)[1])(values, tangents)
            assert f"[6,{of.NV},{of.NV}]" not in str(along)


def test_jax_has_gradients_for_several_values_of_a_field(jax):
    of = homogen.load(ROBOTS / "two_link.urdf", fields={"load": "mass_of:fore"})
    q, qd, qdd = np.array([[0.3, -0.4], [0.1, 0.2], [0.5, -0.6]])

    def energy(q, load):
        return of.jax.inverse_dynamics(q, qd, qdd, load=load) @ qd

    found = jax.vmap(jax.grad(energy), (None, 0))(q, np.array([1.0, 2.5]))
    for load, gradient in zip([1.0, 2.5], found, strict=True):
        of.load = load
        assert np.allclose(gradient, of.inverse_dynamics_vjp(q, qd, qdd, qd).dq)
    changes = jax.vmap(jax.jacfwd(energy), (None, 0))(q, np.array([1.0, 2.5]))
    assert np.allclose(changes, found)


def test_jax_differentiates_by_fields(jax):
    of = homogen.load(ROBOTS / "two_link.urdf", fields={"load": "mass_of:fore"})
    q = np.array([0.3, -0.4])
    slope = jax.jacfwd(lambda load: of.jax.gravity(q, load=load))(1.0)
    before = of.gravity(q)
    of.load = of.load + 1
    assert np.allclose(slope, of.gravity(q) - before)
    several = jax.vmap(lambda load: of.jax.gravity(q, load=load))(np.array([before[1], 2.0]))
    assert np.allclose(several[1], of.jax.gravity(q, load=2.0))
    with pytest.raises(TypeError, match="there are no fields laod"):
        of.jax.gravity(q, laod=1.0)
    # Values of fields are those at the call.
    assert np.allclose(of.jax.gravity(q), of.gravity(q))


# --- SymPy ----------------------------------------------------------------------------------------


def test_sympy_symbols_give_equations():
    sympy = library("sympy")
    of = homogen.load(ROBOTS / "two_link.urdf")
    q, qd, qdd = (sympy.symbols(f"{name}1:3") for name in ("q", "v", "a"))
    torques = of.plain.inverse_dynamics(q, qd, qdd, library=sympy)
    mass = of.plain.mass_matrix(q, library=sympy)
    for row, torque in zip(mass, torques):
        for entry, acceleration in zip(row, qdd):
            rest = sympy.expand_trig(sympy.expand(sympy.diff(torque, acceleration) - entry))
            at = {q[0]: 0.3, q[1]: -0.7}
            assert abs(sympy.simplify(rest).subs(at)) < 1e-12


# --- Numba ----------------------------------------------------------------------------------------


def test_numba_calls_compiled_code(arm):
    numba = library("numba")
    q, qd, qdd = states(arm, ["q", "qd", "qdd"], 12, float)
    dynamics, pose, energy = arm.numba.inverse_dynamics, arm.numba.forward_kinematics, arm.numba.potential_energy
    derivatives = arm.numba.inverse_dynamics_derivatives

    @numba.njit
    def all_states(q, qd, qdd):
        torques = np.empty_like(q)
        total = 0.0
        for k in range(len(q)):
            torques[k] = dynamics(q[k], qd[k], qdd[k])
            total += pose(q[k])[3, 3] + energy(q[k])
        return torques, total

    torques, total = all_states(q, qd, qdd)
    assert same(torques, np.array([arm.inverse_dynamics(*state) for state in zip(q, qd, qdd)]))
    assert np.isclose(total, 12 + arm.potential_energy(q).sum())
    assert same(pose(q[0]), arm.forward_kinematics(q[0]))
    found = derivatives(q[0], qd[0], qdd[0])
    assert type(found) is homogen.results.InverseDynamicsDerivatives
    assert same(found.dqd, arm.inverse_dynamics_derivatives(q[0], qd[0], qdd[0]).dqd)
    with pytest.raises(ValueError, match=r"q must have the shape \(7,\)"):
        pose(q[0, :6])


def test_numba_code_outlives_the_robot():
    library("numba")
    of = robot("arm")
    gravity, q = of.numba.gravity, of.random(0)
    wanted = of.gravity(q)
    del of
    assert same(gravity(q), wanted)


# --- PyTorch --------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def torch():
    return library("torch")


def tensors(torch, of, function, count):
    arrays = states(of, function.parameters()[0], count, float)
    return [torch.tensor(array, requires_grad=True) for array in arrays]


@pytest.mark.parametrize("case", ["arm", "external"])
def test_torch_has_the_gradients_of_finite_differences_and_of_plain_python(torch, case):
    from homogen._torch import DERIVATIVES, Operation, plain

    of = robot(case)
    for name in DERIVATIVES:
        operation = getattr(of.torch, name)
        assert isinstance(operation, Operation)
        given = tensors(torch, of, getattr(of, name), 3)
        wanted = getattr(of, name)(*(tensor.detach().numpy() for tensor in given))
        assert same(operation(*given).detach().numpy(), wanted), name
        assert torch.autograd.gradcheck(operation, given, eps=1e-6, atol=1e-4, rtol=1e-4), name
        other = plain(of, name, None, of._recipe.order)
        weights = torch.randn(wanted.shape, dtype=torch.float64, generator=torch.Generator().manual_seed(1))
        gradients = [torch.autograd.grad((made(*given) * weights).sum(), given) for made in (operation, other)]
        for one, another in zip(*gradients):
            assert torch.allclose(one, another, rtol=1e-8, atol=1e-8), name


# The check of PyTorch looks at gradients of tensors that have none.
@pytest.mark.filterwarnings("ignore:The .grad attribute")
def test_torch_functions_are_operators(torch, arm):
    given = tensors(torch, arm, arm.inverse_dynamics, 4)
    operation = arm.torch.inverse_dynamics
    torch.library.opcheck(torch.ops.homogen.compute.default, (given, operation.key))
    q, qd, qdd = given
    several = torch.func.vmap(operation, (0, 0, None))(q, qd, qdd[0])
    assert torch.allclose(several, operation(q, qd, qdd[0]))
    found = operation(q[0], qd[0], qdd[0])
    pull = torch.func.vmap(lambda row: torch.autograd.grad(found, q, row, retain_graph=True)[0])
    rows = pull(torch.eye(7, dtype=q.dtype))
    wanted = arm.inverse_dynamics_derivatives(*(tensor[0].detach().numpy() for tensor in given))
    assert np.allclose(rows[:, 0].numpy(), wanted.dq)
    single = operation(*(tensor.detach().float() for tensor in given))
    assert single.dtype == torch.float32
    wide = operation(q[:, None], qd, qdd[0])
    wide.sum().backward()
    assert wide.shape == (4, 4, 7) and q.grad.shape == (4, 7) and qdd.grad.shape == (4, 7)
    pose = arm.torch.of("forward_kinematics", frame="link4")
    assert torch.autograd.gradcheck(pose, [q], eps=1e-6, atol=1e-5)


def test_torch_takes_second_derivatives_from_plain_python(torch, arm):
    (q,) = tensors(torch, arm, arm.gravity, 2)
    (slope,) = torch.autograd.grad(arm.torch.gravity(q).sum(), q, create_graph=True)
    with pytest.raises(NotImplementedError, match="the gradient of gravity has no generated derivative"):
        torch.autograd.grad(slope.sum(), q)
    from homogen._torch import plain

    assert torch.autograd.gradgradcheck(plain(arm, "gravity", None, "linear_first"), [q])


def test_torch_computes_the_rest_in_plain_python(torch):
    of = robot("floating")
    given = tensors(torch, of, of.mass_matrix, 2)
    mass = of.torch.mass_matrix(*given)
    assert np.allclose(mass.detach().numpy(), of.mass_matrix(given[0].detach().numpy()))
    assert torch.autograd.gradcheck(of.torch.center_of_mass, given, atol=1e-5)


def test_torch_keeps_no_robots(torch):
    import gc

    from homogen import _torch

    of = robot("arm")
    q = torch.tensor(of.random(0), requires_grad=True)
    torques = of.torch.gravity(q)
    alive = len(_torch._alive)
    del of
    torques.sum().backward()
    assert q.grad.shape == (7,)
    del torques
    gc.collect()
    assert len(_torch._alive) < alive


# --- Pinocchio ------------------------------------------------------------------------------------


def test_pinocchio_computes_the_same(arm):
    pin = library("pinocchio")
    model = pin.buildModelFromUrdf(str(ROBOTS / "panda_class.urdf"))
    data = model.createData()
    assert tuple(model.names)[1:] == arm.joint_names
    q, v, a = (array[0] for array in states(arm, ["q", "qd", "qdd"], 1, float))

    def close(found, wanted):
        return np.allclose(found, wanted, rtol=1e-9, atol=1e-9 * (1 + np.abs(wanted).max()))

    assert close(arm.inverse_dynamics(q, v, a), pin.rnea(model, data, q, v, a))
    assert close(arm.forward_dynamics(q, v, a), pin.aba(model, data, q, v, a))
    assert close(arm.bias(q, v), pin.nonLinearEffects(model, data, q, v))
    mass = np.triu(pin.crba(model, data, q))
    assert close(np.triu(arm.mass_matrix(q)), mass)
    dq, dqd, _ = pin.computeRNEADerivatives(model, data, q, v, a)
    found = arm.inverse_dynamics_derivatives(q, v, a)
    assert close(found.dq, dq) and close(found.dqd, dqd)
    for one, other in zip(arm.forward_dynamics_derivatives(q, v, a), pin.computeABADerivatives(model, data, q, v, a)):
        assert close(one, other)
    frame = model.getFrameId("link5")
    pin.framesForwardKinematics(model, data, q)
    assert close(arm.forward_kinematics(q, frame="link5"), data.oMf[frame].homogeneous)
    for jacobian, reference in [
        (arm.body_jacobian, pin.LOCAL),
        (arm.spatial_jacobian, pin.WORLD),
        (arm.geometric_jacobian, pin.LOCAL_WORLD_ALIGNED),
    ]:
        assert close(jacobian(q, frame="link5"), pin.computeFrameJacobian(model, data, q, frame, reference))
    ahead = pin.integrate(model, q, v)
    assert close(arm.integrate(q, v), ahead) and close(arm.difference(q, ahead), pin.difference(model, q, ahead))
    assert close(arm.neutral(), pin.neutral(model))
