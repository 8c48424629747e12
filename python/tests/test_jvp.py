"""Jacobian-vector products: finite differences, and directions that are left out."""

import numpy as np
import pytest
from conftest import robot


@pytest.mark.parametrize("case", ["arm", "floating", "external"])
def test_directional_derivatives_are_those_of_differences(case):
    of = robot(case)
    rng = np.random.default_rng(4)
    q, (qd, third), changes = of.random(4, 3), rng.uniform(-1, 1, (2, 3, of.NV)), rng.uniform(-1, 1, (3, 3, of.NV))
    links = of._recipe.facts()["external"]
    further = [rng.uniform(-1, 1, (3, links, 6))] if links else []
    options = {"actions": further[0]} if links else {}
    for name in ("inverse_dynamics", "forward_dynamics"):
        function, product = getattr(of, name), getattr(of, name + "_jvp")
        found = product(q, qd, third, *changes, **options)
        assert np.allclose(found.value, function(q, qd, third, *further), rtol=1e-11)
        h = 1e-6
        ends = [
            function(of.integrate(q, s * h * changes[0]), qd + s * h * changes[1], third + s * h * changes[2], *further)
            for s in (-1, 1)
        ]
        expected = (ends[1] - ends[0]) / (2 * h)
        assert np.allclose(found.change, expected, atol=1e-6 * np.abs(expected).max())
        part = product(q, qd, third, qd_change=changes[1, 0], **options)
        by = getattr(of, name + "_derivatives")(q, qd, third, *further)
        assert np.allclose(part.change, by.dqd @ changes[1, 0])
        with pytest.raises(TypeError, match="q_change is missing"):
            product(q, qd, third, **options)
        with pytest.raises(ValueError, match="q_change has the shape"):
            product(q, qd, third, changes[0, :, :-1], **options)
