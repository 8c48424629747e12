// Assembles the view of a robot from its data: sections with a common configuration and a common selected name.

// Puts a robot on the page, whose elements are those of `robot.html`. `complete` resolves to a function with its count,
// `explain` to one with its code, `measure` to measured errors of its results in f32, or null; `moved` is called with the
// arguments of functions when they change, `chosen` with the number of the link whose frame is chosen, and `signal` ends
// what listens outside of the view. Returns the interface for scripts.
function present(data, { complete = async (own) => own, explain: explained = complete, measure = async () => null, moved = () => {}, chosen = () => {}, signal = undefined } = {}) {
  const { skeleton, report } = data;
  data.neutral = rest(skeleton);

  const robot = {
    ...prepared(data),
    skeleton,
    layouts: data.layouts,
    letters: data.letters,
    tip: report.tip,
  };

  // Shown layers, and the selected name. Bodies are shown at first where the description has shapes.
  const shown = { frames: null, masses: true, bodies: robot.links.some((link) => link.shapes?.length), names: false, frame: null, ellipsoid: null };
  let pointed = { open: null, name: null, pinned: false, bodies: new Set() };
  let now = poses(skeleton, data.neutral);
  // Arguments of functions: q of the joints, all velocities 0 or all 1, or as given; weights and changes 1; a wrench is a unit force along
  // z; all others 0.
  const rates = (rate) => skeleton.velocities.map(() => rate);
  const changes = () => Object.fromEntries(["q_change", "qd_change", "qdd_change", "tau_change"].map((name) => [name, rates(1)]));
  let given = { q: data.neutral, qd: rates(0), qdd: rates(0), tau: rates(0), weights: rates(1), ...changes(), wrench: [0, 0, 0, 0, 0, 1] };
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
  // The frame of the pose: that of the functions, or the last one.
  const ends = robot.links.filter((link) => link.end);
  const tip = skeleton.links.findIndex((link) => link.name === report.tip);
  shown.frame = tip >= 0 ? tip : (ends[ends.length - 1]?.index ?? null);
  const frameChoice = el("select", { id: "frame", "aria-label": "Frame of the pose", title: "A click on the picture chooses a frame, too", onchange: () => choose(Number(frameChoice.value)) },
    skeleton.links.map((link, k) => el("option", { value: String(k) }, link.name)));
  const matrix = el("div", { id: "matrix-of-pose" });
  function pose() {
    if (shown.frame === null) return;
    frameChoice.value = String(shown.frame);
    matrix.replaceChildren(poseTable(now.links[shown.frame]));
  }
  function choose(link) {
    shown.frame = link;
    shown.ellipsoid = null;
    pose();
    chosen(link);
    redraw();
  }
  // The camera follows a floating base.
  const base = skeleton.bodies.findIndex(({ by: moved, parent }) => parent === null && moved?.manifold === "floating");
  const joints = jointSection(data, robot.reach, (q, rate) => {
    const before = now;
    now = poses(skeleton, q);
    if (base >= 0) camera.target = plus(camera.target, minus(originOf(now.bodies[base]), originOf(before.bodies[base])));
    pose();
    take({ q: [...q], ...(rate === null ? {} : { qd: rates(rate) }) });
    redraw();
  });
  by("joints").append(...joints.section.filter(Boolean));
  if (shown.frame !== null) by("pose").append(el("p", {}, el("var", {}, el("b", {}, "M"), el("sub", {}, "0,n")), " of ", frameChoice), matrix);

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
  by("layers").append(choice, layer("bodies", "bodies"), layer("masses", "centres of mass"), layer("names", "names"));

  // The constant sections.
  const functions = functionSection(robot, data, point, { measure, explain: explained, complete: async (own) => {
    const already = data.layouts.length;
    await complete(own);
    if (data.layouts.length !== already) offer();
    return own;
  } });
  by("functions").append(...functions.section.flat(Infinity).filter(Boolean));
  by("read").append(...readSection(data).filter(Boolean));
  by("letters").append(...letterSection(data.letters));
  explain();

  // The camera.
  moveByHand(canvas, redraw, whole);
  by("nearer").addEventListener("click", () => { zoom(0.8); redraw(); });
  by("farther").addEventListener("click", () => { zoom(1.25); redraw(); });
  by("whole").addEventListener("click", () => { whole(); redraw(); });
  // The joint or link that is pointed at, with what it mimics or closes.
  const mimicked = new Map(report.mimicked.map((mimic) => [mimic.joint, mimic]));
  const about = (body) => {
    const mimic = mimicked.get(body.joint);
    const link = body.link ? ` → ${body.link}` : "";
    return mimic ? `${body.name} = ${short(mimic.multiplier)} × ${mimic.of}${mimic.offset ? ` + ${short(mimic.offset)}` : ""}${link}` : body.name + link;
  };
  const near = (event, reach) => {
    const box = canvas.getBoundingClientRect();
    const at = [event.clientX - box.left, event.clientY - box.top];
    const from = eye();
    const spot = (point, more) => {
      const { x, y } = project(from, point);
      return { x, y, far: Math.hypot(x - at[0], y - at[1]), ...more };
    };
    const links = robot.links.map((link) => spot(originOf(now.links[link.index]), { link }));
    const bodies = skeleton.bodies.flatMap((body, k) => (body.by === null ? [] : [spot(originOf(now.bodies[k]), { text: about(body) })]));
    const loops = skeleton.loops.map(({ name, kind }, k) => spot(originOf(now.loops[k][0]), { text: `loop ${name}: ${kind}` }));
    const within = (list) => list.filter(({ far }) => far < reach).sort((a, b) => a.far - b.far);
    return { links: within(links), tags: within([...loops, ...bodies, ...links.map((one) => ({ ...one, text: one.link.name }))]) };
  };
  canvas.addEventListener("pointermove", (event) => {
    const tag = by("tag");
    const first = near(event, 14).tags[0];
    tag.hidden = !first || event.buttons > 0;
    if (first) {
      tag.textContent = first.text;
      tag.style.left = `${first.x}px`;
      tag.style.top = `${first.y}px`;
    }
  });
  // A click that does not move the camera chooses the nearest frame; further clicks go through those in one place.
  let pressed = null;
  canvas.addEventListener("pointerdown", (event) => { pressed = [event.clientX, event.clientY]; });
  canvas.addEventListener("pointerup", (event) => {
    if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    const { links } = near(event, 18);
    const same = links.filter(({ far }) => far < links[0].far + 1).map(({ link }) => link.index);
    if (same.length) choose(same[(same.indexOf(shown.frame) + 1) % same.length]);
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
    // Chooses the frame of a link by its number.
    choose,
    chosen: () => shown.frame,
    // The place of a link's frame in the picture \[px\].
    place: (link) => project(eye(), originOf(now.links[link])),
    // Draws an ellipsoid at the chosen frame: its axes, in units of the robot's size.
    ellipsoid: (axes) => { shown.ellipsoid = axes; redraw(); },
    reach: robot.reach,
    // Sets arguments of functions besides q.
    give: take,
    given: () => given,
    // Shows counts of a function that has been completed.
    fill: (own) => functions.fill(own),
    // M₀ of every link, by name: rows 1 to 3.
    poses: () => Object.fromEntries(skeleton.links.map((link, k) => [link.name, now.links[k]])),
    // The code of a function, as printed.
    code: async (name) => unpacked((await explained(functionOf(name))).code),
    // Its names: the kind and the present value of each.
    names: async (name) => {
      const open = await opened(robot, await explained(functionOf(name)));
      const { analysis, helpers } = open;
      const value = worth(open, given);
      const kind = (own) => (helpers.has(own) ? "helper" : meaning(robot, open, own).kind);
      return [...analysis.names.keys()].map((own) => ({ name: own, kind: kind(own), worth: helpers.has(own) ? NaN : value(own) }));
    },
  };
}
