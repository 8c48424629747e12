// Assembles the view of a robot from its data: sections with a common configuration and a common selected name.

// Puts a robot on the page, whose elements are those of `robot.html`. `complete` resolves to a function with its code,
// `moved` is called with the arguments of functions when they change, and `signal` ends what listens outside of the
// view. Returns the interface for scripts.
function present(data, { complete = async (own) => own, moved = () => {}, signal = undefined } = {}) {
  const { skeleton, report } = data;
  data.neutral = rest(skeleton);

  const robot = {
    ...prepared(data),
    skeleton,
    layouts: data.layouts,
    letters: data.letters,
    tip: report.tip,
  };

  // Shown layers, and the selected name.
  const shown = { frames: null, masses: true, names: false };
  let pointed = { open: null, name: null, pinned: false, bodies: new Set() };
  let now = poses(skeleton, data.neutral);
  // Arguments of functions: q of the joints, all velocities 0 or all 1, or as given; weights 1; all others 0.
  const rates = (rate) => skeleton.velocities.map(() => rate);
  let given = { q: data.neutral, qd: rates(0), qdd: rates(0), tau: rates(0), weights: rates(1) };
  const canvas = by("picture");

  let waiting = false;
  function redraw() {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      paint(canvas, robot, now, shown, pointed.bodies);
    });
  }

  function whole() {
    const { center, reach } = around(robot.links, now);
    frame(center, reach + robot.thick);
  }

  // The head of the page.
  document.title = `${report.robot} — homogen`;
  by("robot").textContent = report.robot;
  by("origin").append(
    ...[report.file ? [named(report.file), ", "] : [],
      `${counted(report.joints.length, "joint")}, ${counted(skeleton.velocities.length, "velocity", "velocities")}, ${counted(skeleton.links.length, "link")}; from `,
      named(report.base), report.tip ? [" to ", named(report.tip)] : []].flat(Infinity));

  // The configuration.
  const take = (more) => {
    given = { ...given, ...more };
    if (pointed.name) explain();
    moved(given);
  };
  const joints = jointSection(data, robot.reach, (q, rate) => {
    now = poses(skeleton, q);
    const tip = skeleton.links.findIndex((link) => link.name === report.tip);
    if (tip >= 0) by("pose")?.replaceChildren(...poseTable(report.tip, now.links[tip]).flat());
    take({ q: [...q], ...(rate === null ? {} : { qd: rates(rate) }) });
    redraw();
  });
  by("joints").append(...joints.section.filter(Boolean));

  // The selected name.
  function explain() {
    const panel = by("explain");
    const { open, name, pinned } = pointed;
    panel.classList.toggle("pinned", pinned);
    panel.classList.toggle("filled", name !== null);
    if (name === null) panel.replaceChildren(...invitation());
    else panel.replaceChildren(...explanation(robot, open, name, given).flat(Infinity).filter(Boolean));
  }

  function point(open, name, pinned) {
    if (pointed.pinned && !pinned && pointed.open === open) return;
    if (pointed.name === name && pointed.open === open && pointed.pinned === pinned) return;
    if (pointed.open && pointed.open !== open) pointed.open.lines.mark(null);
    pointed = { open, name, pinned, bodies: bodiesOf(robot, meaning(robot, open, name)) };
    open.lines.mark(name);
    // Frames are those of the function.
    if (shown.frames !== null && shown.frames !== "described") select(open.own.layout);
    explain();
    redraw();
  }

  function unpoint() {
    if (pointed.open) pointed.open.lines.mark(null);
    pointed = { open: null, name: null, pinned: false, bodies: new Set() };
    explain();
    redraw();
  }

  by("explain").addEventListener("click", (event) => {
    if (event.target.closest("#unpin")) {
      unpoint();
      return;
    }
    const reference = event.target.closest("[data-name]");
    if (!reference || !pointed.open) return;
    const { open } = pointed;
    point(open, reference.dataset.name, true);
    open.lines.go(reference.dataset.name);
  });
  document.addEventListener("keydown", (event) => { if (event.key === "Escape") unpoint(); }, { signal });

  // The layers.
  const choices = () => [["", "no frames"], ["described", "frames as described"],
    ...data.layouts.map((_, k) => {
      const users = data.functions.filter((own) => own.layout === k).map((own) => own.name);
      const more = users.length > 1 ? ` and ${users.length - 1} more` : "";
      return [String(k), `frames chosen for ${users[0]}${more}`];
    })];
  const choice = el("select", { id: "frames", "aria-label": "Which frames are drawn", onchange: () => {
    shown.frames = choice.value === "" ? null : choice.value === "described" ? "described" : Number(choice.value);
    redraw();
  } });
  // Functions that are expanded later bring their frames.
  function offer() {
    const { value } = choice;
    choice.replaceChildren(...choices().map(([entry, text]) => el("option", { value: entry }, text)));
    choice.value = value;
  }
  offer();
  function select(frames) {
    shown.frames = frames;
    choice.value = frames === null ? "" : String(frames);
  }
  const layer = (name, text) => {
    const box = el("input", { type: "checkbox", onchange: () => { shown[name] = box.checked; redraw(); } });
    box.checked = shown[name];
    return el("label", {}, box, ` ${text}`);
  };
  by("layers").append(choice, layer("masses", "centres of mass"), layer("names", "names"));

  // The constant sections.
  const functions = functionSection(robot, data, point, async (own) => {
    const already = data.layouts.length;
    await complete(own);
    if (data.layouts.length !== already) offer();
    return own;
  });
  by("functions").append(...functions.section.flat(Infinity).filter(Boolean));
  by("read").append(...readSection(data).filter(Boolean));
  by("letters").append(...letterSection(data.letters));
  explain();

  // The camera.
  moveByHand(canvas, redraw, whole);
  by("nearer").addEventListener("click", () => { zoom(0.8); redraw(); });
  by("farther").addEventListener("click", () => { zoom(1.25); redraw(); });
  by("whole").addEventListener("click", () => { whole(); redraw(); });
  canvas.addEventListener("pointermove", (event) => {
    const tag = by("tag");
    const box = canvas.getBoundingClientRect();
    const at = [event.clientX - box.left, event.clientY - box.top];
    const from = eye();
    const near = skeleton.bodies.map((body, k) => {
      const { x, y } = project(from, originOf(now.bodies[k]));
      return { body, x, y, far: Math.hypot(x - at[0], y - at[1]) };
    }).filter(({ body, far }) => body.by !== null && far < 14).sort((a, b) => a.far - b.far)[0];
    tag.hidden = !near || event.buttons > 0;
    if (near) {
      tag.textContent = near.body.name;
      tag.style.left = `${near.x}px`;
      tag.style.top = `${near.y}px`;
    }
  });
  canvas.addEventListener("pointerleave", () => { by("tag").hidden = true; });
  new ResizeObserver(redraw).observe(canvas);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw, { signal });
  matchMedia("print").addEventListener("change", () => paint(canvas, robot, now, shown, pointed.bodies), { signal });
  joints.start();
  whole();

  const functionOf = (name) => data.functions.find((own) => own.name === name);

  return {
    robot: report.robot,
    functions: () => data.functions.map((own) => own.name),
    q: () => [...given.q],
    // Moves the joints; quaternions are normalised where they are used.
    move: (values) => joints.put(values),
    // Sets arguments of functions besides q.
    give: take,
    given: () => given,
    // Shows counts of a function that has been completed.
    fill: (own) => functions.fill(own),
    // M₀ of every link, by name: rows 1 to 3.
    poses: () => Object.fromEntries(skeleton.links.map((link, k) => [link.name, now.links[k]])),
    // The code of a function, as printed.
    code: async (name) => unpacked((await complete(functionOf(name))).code),
    // Its names: the kind and the present value of each.
    names: async (name) => {
      const open = await opened(robot, await complete(functionOf(name)));
      const { analysis, helpers } = open;
      const value = worth(open, given);
      const kind = (own) => (helpers.has(own) ? "helper" : meaning(robot, open, own).kind);
      return [...analysis.names.keys()].map((own) => ({ name: own, kind: kind(own), worth: helpers.has(own) ? NaN : value(own) }));
    },
  };
}
