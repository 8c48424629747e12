// The code as files and as projects: a language, a type of numbers and functions; the command line that makes the same.

const LANGUAGES = [["rust", "Rust"], ["c", "C99"], ["cpp", "C++17"], ["python", "Python"], ["llvm", "LLVM IR"]];

const PROJECTS = [["crate", "Crate", "A crate without dependencies"], ["cmake", "C with CMake", "A static library in C99"],
  ["cmake --language cpp", "C++ with CMake", "A header in C++17 without sources"],
  ["python", "Python package", "A package without dependencies"], ["firmware", "Firmware", "A control loop for a Cortex-M4 that runs under QEMU"]];

// Number of letters that are shown of a file.
const LETTERS = 40_000;

// The section; `ask` resolves to the files of a request. `make` makes the files that are shown.
function fileSection(data, ask) {
  let language = "rust";
  const scalar = el("select", { "aria-label": "Type of numbers", onchange: () => make() }, ["f64", "f32"].map((name) => el("option", { value: name }, name)));
  const tabs = LANGUAGES.map(([name, title]) => el("button", { type: "button", role: "tab", "aria-selected": String(name === language), onclick: (event) => {
    language = name;
    for (const tab of tabs) tab.setAttribute("aria-selected", String(tab === event.currentTarget));
    make();
  } }, title));
  // One box for each function of the request; those of further frames come with it.
  const names = [...new Set(data.functions.filter((own) => own.of === null).map((own) => own.name))];
  const preferred = ["inverse_dynamics", "forward_kinematics"].filter((name) => names.includes(name));
  const boxes = names.map((name) => {
    const box = el("input", { type: "checkbox", value: name, onchange: () => make() });
    box.checked = preferred.includes(name);
    return { name, box, label: el("label", {}, box, " ", el("code", {}, name)) };
  });
  const wanted = () => boxes.filter(({ box }) => box.checked).map(({ name }) => name);
  const refused = (answer) => answer.errors.map(({ message, hint }) => el("p", {}, message, hint ? el("small", {}, ` — ${hint}`) : null));
  const result = el("div", { class: "files" });
  let urls = [];
  let last = 0;
  async function make() {
    const functions = wanted();
    const own = (last += 1);
    result.classList.add("busy");
    if (!functions.length) {
      result.replaceChildren(el("p", { class: "small" }, "Choose functions."));
      return;
    }
    const answer = await ask({ do: "code", language, scalar: scalar.value, functions }).catch(() => null);
    if (own !== last || answer === null) return;
    result.classList.remove("busy");
    for (const url of urls) URL.revokeObjectURL(url);
    urls = [];
    if (answer.errors) {
      result.replaceChildren(...refused(answer));
      return;
    }
    const files = answer.files.map(({ name, text }) => {
      const url = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
      urls.push(url);
      return el("details", { class: "file" },
        el("summary", {}, el("code", {}, name), el("small", {}, ` ${grouped(text.split("\n").length)} lines, ${grouped(Math.ceil(new Blob([text]).size / 1000))} kB`),
          el("a", { class: "download", href: url, download: name }, "Download")),
        el("pre", { class: "code", tabindex: "0" }, text.length > LETTERS ? `${text.slice(0, LETTERS)}\n…` : text));
    });
    result.replaceChildren(...files,
      el("p", { class: "small" }, "The same from a shell:"), el("code", { class: "state", id: "command" }, answer.command));
  }
  const all = el("button", { type: "button", onclick: () => {
    const every = boxes.every(({ box }) => box.checked);
    for (const { box } of boxes) box.checked = !every;
    make();
  } }, "All or none");
  // A project as an archive, and the command that writes the same folder.
  const project = el("div", { class: "files", id: "project" });
  let archive = null;
  async function download(kind) {
    project.classList.add("busy");
    const answer = await ask({ do: "project", kind, scalar: scalar.value, functions: wanted() }).catch(() => null);
    if (answer === null) return;
    project.classList.remove("busy");
    if (answer.errors) {
      project.replaceChildren(...refused(answer));
      return;
    }
    if (archive) URL.revokeObjectURL(archive);
    archive = URL.createObjectURL(zipped(answer.folder, answer.files));
    const link = el("a", { class: "download", href: archive, download: `${answer.folder}.zip` }, `${answer.folder}.zip`);
    project.replaceChildren(
      el("p", {}, link, el("small", {}, ` ${answer.files.map(({ name }) => name).join(", ")}`)),
      el("p", { class: "small" }, "The same folder from a shell:"), el("code", { class: "state", id: "project-command" }, answer.command));
    link.click();
  }
  const projects = PROJECTS.map(([kind, title, help]) => el("button", { type: "button", "data-project": kind, title: help, onclick: () => download(kind) }, title));
  const section = [
    el("div", { class: "title" }, el("h2", { id: "files-title" }, "Take the code"), el("div", { class: "buttons" }, el("div", { class: "tabs", role: "tablist" }, tabs), scalar)),
    el("details", { class: "choice" }, el("summary", {}, "Functions in the file"), el("div", { class: "boxes" }, boxes.map(({ label }) => label)), all),
    result,
    el("div", { class: "title" }, el("h3", {}, "As a project"), el("div", { class: "buttons" }, projects)),
    project,
  ];
  return { section, make };
}
