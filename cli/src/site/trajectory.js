// A motion from one stored configuration to another: a polynomial of degree five, at rest at both ends, so that
// velocities and accelerations are continuous. It plays, and it can be plotted.

// Share of the way after a share of the time, with its first and second derivatives by it.
const smooth = (u) => [u ** 3 * (10 + u * (6 * u - 15)), 30 * (u * (1 - u)) ** 2, 60 * u * (1 - u) * (1 - 2 * u)];

// The section, null for a robot without such joints or with loops, which would open on the way. `go` moves the robot to a
// state, `changed` is called when the motion changes, `present` returns the configuration. `at` returns the state at a
// time, null before both ends are stored.
function trajectorySection(data, { present: now, go, changed }) {
  const { bodies, loops, velocities } = data.skeleton;
  // Coordinates with their velocities; joints with quaternions stay as they are at the start.
  const moves = new Map(bodies.flatMap(({ by: moved, velocity }) => (moved && !moved.manifold ? [[moved.coordinate, velocity]] : [])));
  if (!moves.size || loops.length) return null;
  let [from, to, seconds, time] = [now(), null, 2, 0];
  let playing = 0;

  const at = (when) => {
    if (!to) return null;
    const [share, rate, change] = smooth(Math.min(1, Math.max(0, when / seconds)));
    const state = { q: [...from], qd: velocities.map(() => 0), qdd: velocities.map(() => 0) };
    for (const [k, velocity] of moves) {
      const way = to[k] - from[k];
      state.q[k] = from[k] * (1 - share) + to[k] * share;
      state.qd[velocity] = (way * rate) / seconds;
      state.qdd[velocity] = (way * change) / seconds ** 2;
    }
    return state;
  };

  const clock = el("output", { class: "clock" });
  const slider = el("input", { type: "range", min: "0", step: "any", disabled: true, "aria-label": "Time", oninput: () => { pause(); show(Number(slider.value)); } });
  const duration = el("input", { type: "text", class: "typed", inputmode: "decimal", value: "2", "aria-label": "Duration in s", onchange: () => {
    const wanted = Number(duration.value.replace(",", "."));
    if (wanted > 0 && wanted < 1e4) seconds = wanted;
    duration.value = String(seconds);
    update();
  } });
  const button = (text, title, onclick) => el("button", { type: "button", title, onclick }, text);
  const play = button("Play", "The robot moves from the start to the end", () => (playing ? pause() : run()));
  play.disabled = true;
  const section = el("details", { class: "part", id: "trajectory", open: true },
    el("summary", {}, el("h3", {}, "Trajectory")),
    el("p", { class: "plotted" },
      button("Start here", "The present configuration is the start", () => { from = now(); update(); }),
      button("End here", "The present configuration is the end", () => { to = now(); update(); }),
      el("label", {}, "in ", duration, " s"), play, slider, clock),
    el("p", { class: "small" }, "From the stored start to the stored end by a polynomial of degree five; q̇ and q̈ of the table above are those of the motion."));

  function show(when) {
    time = when;
    slider.value = String(when);
    clock.textContent = `${when.toFixed(2)} s`;
    go(at(when));
  }
  function update() {
    slider.disabled = play.disabled = !to;
    slider.max = String(seconds);
    section.querySelectorAll("button")[1].classList.toggle("chosen", to !== null);
    time = Math.min(time, seconds);
    changed();
  }
  function run() {
    const begin = performance.now() - (time < seconds ? time : 0) * 1000;
    play.textContent = "Pause";
    const step = () => {
      if (!section.isConnected) return;
      const when = Math.min(seconds, (performance.now() - begin) / 1000);
      show(when);
      if (when < seconds) playing = requestAnimationFrame(step);
      else pause();
    };
    playing = requestAnimationFrame(step);
  }
  function pause() {
    cancelAnimationFrame(playing);
    playing = 0;
    play.textContent = "Play";
  }
  return { section, at, pause, seconds: () => seconds, time: () => time };
}
