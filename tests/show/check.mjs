// Checks pages of `homogen show` in a browser.
//
// In: the program `homogen`, Chromium, an output folder. Out: pictures in that folder, or an error for the first check
// that fails. Poses of links are compared with `homogen eval`, which shares with a page only the generated text.

import { execFileSync } from "node:child_process";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const [homogen, chromium, output] = process.argv.slice(2);
const root = resolve(import.meta.dirname, "../..");
const WIDE = { width: 1440, height: 900 };
const PHONE = { width: 375, height: 812, ratio: 2, touch: true };

const ROBOTS = [
  { name: "panda", words: ["robots/panda_class.urdf", "--tip", "link8"], links: ["link1", "link4", "link8"] },
  { name: "quadruped", words: ["robots/quadruped.urdf", "--floating", "--tip", "fl_foot"], links: ["base", "fl_foot", "hr_foot"] },
  { name: "humanoid", joints: 29, links: ["left_arm_6", "right_leg_6"],
    words: ["tests/robots/humanoid.urdf", "--tip", "left_arm_6", ...["left_leg_7", "right_leg_7", "left_arm_7", "right_arm_7"].flatMap((link) => ["--drop", link])] },
  { name: "joints", words: ["tests/show/joints.urdf", "--tip", "thumb", "--functions", "forward_kinematics,body_jacobian,gravity,inverse_dynamics,mass_matrix,center_of_mass"], links: ["a", "d", "f", "i", "thumb", "camera", "drone"] },
  { name: "loops", closed: true, words: ["tests/show/loops.urdf", "--tip", "block"], links: ["wheel", "bar", "lever"] },
  { name: "locked", words: ["tests/show/joints.urdf", "--tip", "i", "--lock", "slide=0.1", "--lock", "spin", "--functions", "forward_kinematics,gravity+mass_matrix"], links: ["c", "i", "drone"] },
];

let checks = 0;
function check(holds, what) {
  checks += 1;
  if (!holds) throw new Error(what);
}

const run = (...words) => execFileSync(homogen, words, { cwd: root, encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] });

// Results of `homogen eval` at states.
function evaluated(words, name, states, frame = []) {
  const file = join(output, "states.json");
  writeFileSync(file, JSON.stringify({ states }));
  const options = words.filter((word, k) => word !== "--functions" && words[k - 1] !== "--functions");
  return JSON.parse(run("eval", ...options, "--function", name, ...frame, "--states", file, "--format", "json")).results;
}

const near = (a, b, most) => Math.abs(a - b) <= most;

// Drags every slider to a different random position.
const DRAG = (seed) => `(() => {
  let state = ${seed};
  for (const slider of document.querySelectorAll(".sliders input[type=range]")) {
    state = (state * 16807) % 2147483647;
    const [low, high] = [Number(slider.min), Number(slider.max)];
    slider.value = String(low + (high - low) * (0.1 + 0.8 * state / 2147483647));
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }
})()`;

async function links(page, { name, words, links: wanted, closed: closes }) {
  const states = [];
  const seen = [];
  for (const seed of [1, 77, 4242]) {
    await page.ask(DRAG(seed));
    states.push({ q: await page.ask("homogen.q()") });
    seen.push(await page.ask("homogen.poses()"));
  }
  check(JSON.stringify(states[0]) !== JSON.stringify(states[1]), `${name}: joints do not move`);
  if (closes) {
    for (const residuals of evaluated(words, "constraint", states)) {
      check(residuals.every((one) => Math.abs(one) < 1e-9), `${name}: loops are open by ${residuals.join(", ")}`);
    }
  }
  for (const link of wanted) {
    const results = evaluated(words, "forward_kinematics", states, ["--frame", link]);
    results.forEach((rows, k) => rows.slice(0, 3).flat().forEach((entry, at) => {
      const own = seen[k][link][at];
      check(near(own, entry, 1e-9), `${name}: entry ${at} of ${link} is ${own} on the page and ${entry} by eval`);
    }));
  }
}

// Every defined name has an explanation.
async function names(page, { name }) {
  for (const own of await page.ask("homogen.functions()")) {
    const found = await page.ask(`homogen.names(${JSON.stringify(own)})`);
    const unknown = found.filter(({ name: one, kind }) => kind === "other" && !/^(angles|sines|cosines|y)_*$/.test(one));
    check(unknown.length === 0, `${name}: ${unknown.map((one) => one.name).join(", ")} in ${own} has no explanation`);
    const worthless = found.filter(({ kind, worth }) => ["entry", "part", "argument", "sum", "angle"].includes(kind) && !Number.isFinite(worth));
    check(worthless.length === 0, `${name}: ${worthless.map((one) => one.name).join(", ")} of ${own} has no value`);
  }
}

// Values on the page equal those of `homogen eval`, at rest and with all rates at 1.
async function values(page, { name, words }) {
  for (const [own, moving] of [["gravity", false], ["inverse_dynamics", true]]) {
    await page.ask(`(() => { const box = document.querySelector("#moving"); if (box.checked !== ${moving}) box.click(); })()`);
    const text = await page.ask(`homogen.code("${own}")`);
    const worth = new Map((await page.ask(`homogen.names("${own}")`)).map((one) => [one.name, one.worth]));
    const result = text.slice(text.lastIndexOf("[") + 1, text.lastIndexOf("]")).split(",").map((one) => one.trim()).filter(Boolean);
    const q = await page.ask("homogen.q()");
    const count = await page.ask(`JSON.parse(document.querySelector("#data").textContent).skeleton.velocities.length`);
    const [expected] = evaluated(words, own, [{ q, qd: new Array(count).fill(moving ? 1 : 0), qdd: new Array(count).fill(0) }]);
    check(result.length === expected.length, `${name}: ${result.length} results of ${own}`);
    result.forEach((one, k) => {
      const literal = /^k\((.*)\)$/.exec(one);
      const value = literal ? Number(literal[1]) : one.startsWith("-") ? -worth.get(one.slice(1)) : worth.get(one);
      check(near(value, expected[k], 1e-9 * Math.max(1, Math.abs(expected[k]))), `${name}: ${one} of ${own} is worth ${value} on the page and ${expected[k]} by eval`);
    });
  }
}

const PANEL = `document.querySelector("#explain").textContent`;

// Pointing by mouse, keys and buttons.
async function pointing(page) {
  const card = `[data-function="inverse_dynamics"]`;
  await page.click(`${card} > summary`);
  await page.until(`document.querySelector('${card} .code .d') !== null`);
  const wanted = await page.ask(`[...document.querySelectorAll('${card} .code .d')].map((spot) => spot.dataset.n).find((name) => /_0_3_in_3_[xyz]$/.test(name))`);
  await page.hover(`${card} .d[data-n="${wanted}"]`);
  await page.until(`${PANEL}.includes("${wanted}")`);
  const explanation = await page.ask(PANEL);
  for (const part of [/matrix/, /link 3/, /frame 3/, /\(\d+\)/, /read by/, /line/]) check(part.test(explanation), `${wanted}: ${part} is not in "${explanation}"`);
  check(await page.ask(`document.querySelectorAll("#explain .matrix .meant").length`) > 0, "no entry is marked");
  check(await page.ask(`document.querySelectorAll('${card} .reader').length`) > 0, "its readers are not marked");
  check(await page.ask(`[...document.querySelectorAll('${card} .same')].every((spot) => spot.dataset.n === "${wanted}")`), "other names are marked");
  // Keys: to the next names, and out of the panel.
  await page.ask(`document.querySelector('${card} .code').focus()`);
  for (const key of ["ArrowRight", "ArrowRight", "ArrowDown"]) await page.key(key);
  const current = await page.ask(`document.querySelector('${card} .current').dataset.n`);
  await page.until(`document.querySelector("#explain code").textContent === "${current}"`);
  await page.key("Escape");
  check(/point at a name/.test(await page.ask(PANEL)), "Escape does not close the panel");
  // A value links to its operands.
  await page.click(`${card} .d[data-n="t_9"]`);
  check(await page.ask(`document.querySelector("#explain.pinned .mathematics").textContent.length`) > 2, "t_9 has no expression");
  const reference = await page.ask(`document.querySelector("#explain .mathematics [data-name]").dataset.name`);
  await page.click("#explain .mathematics [data-name]");
  await page.until(`document.querySelector("#explain code").textContent === "${reference}"`);
}

// The picture changes when it is rotated and when frames are drawn.
async function rotating(page) {
  const picture = () => page.ask(`new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(document.querySelector("#picture").toDataURL()))))`);
  const seen = [await picture()];
  const changes = async (what) => {
    const now = await picture();
    check(!seen.includes(now), `the picture does not change: ${what}`);
    seen.push(now);
  };
  const at = await page.spot("#picture");
  await page.mouse("mousePressed", at, { button: "left", buttons: 1 });
  await page.mouse("mouseMoved", { x: at.x + 60, y: at.y + 20 }, { button: "left", buttons: 1 });
  await page.mouse("mouseReleased", { x: at.x + 60, y: at.y + 20 }, { button: "left" });
  await changes("by the mouse");
  await page.ask(`document.querySelector("#picture").focus()`);
  for (const key of ["ArrowLeft", "ArrowUp", "+"]) {
    await page.key(key);
    await changes(key);
  }
  for (const value of ["described", "0", ""]) {
    await page.ask(`(() => { const choice = document.querySelector("#frames"); choice.value = "${value}"; choice.dispatchEvent(new Event("change")); })()`);
    if (value !== "") await changes(`frames: ${value}`);
  }
}

const background = `getComputedStyle(document.body).backgroundColor`;

async function inBrowser(browser, robot) {
  const file = join(output, `${robot.name}.html`);
  run("show", ...robot.words, "-o", file);
  const { size } = statSync(file);
  // That of the humanoid has all 45 functions.
  check(size < 5.5e6, `${robot.name}: ${size} bytes`);
  const url = pathToFileURL(file).href;
  const page = await browser.open(url, WIDE);
  if (robot.joints) check((await page.ask("homogen.q().length")) === robot.joints, `${robot.name}: number of joints`);
  await links(page, robot);
  await names(page, robot);
  if ((await page.ask("homogen.functions()")).includes("gravity")) await values(page, robot);
  if (robot.name === "panda") {
    await rotating(page);
    await pointing(page);
    await page.paper(join(output, "panda.pdf"));
  }

  const phone = await browser.open(url, PHONE);
  for (const own of await phone.ask("homogen.functions()")) {
    await phone.ask(`document.querySelector('[data-function="${own}"]').open = true`);
  }
  await phone.until(`[...document.querySelectorAll(".function")].every((card) => card.querySelector(".code .d"))`);
  const width = await phone.ask("document.documentElement.scrollWidth");
  check(width <= PHONE.width, `${robot.name}: ${width} px wide on a phone`);
  const name = `.function[open] .code .d[data-n="t_1"]`;
  if (await phone.ask(`document.querySelector('${name}') !== null`)) {
    await phone.tap(name);
    await phone.until(`document.querySelector("#explain.filled code")?.textContent === "t_1"`);
  }

  const dark = await browser.open(url, { ...WIDE, dark: true });
  check((await dark.ask(background)) !== (await page.ask(background)), `${robot.name}: the dark theme has the colors of the light one`);
  for (const one of [page, phone, dark]) {
    check(one.complaints.length === 0, `${robot.name}: ${one.complaints.join("; ")}`);
    check(one.requests.every((request) => request === url), `${robot.name}: requests ${one.requests.join(", ")}`);
  }
  console.log(`${robot.name}: ${(size / 1e6).toFixed(2)} MB, opens in ${page.took.toFixed(0)} ms`);
}

// Names that contain HTML stay text, and an inserted script does not run.
async function hostile(browser) {
  const evil = "</script><script>window.lost = 1</script><img src=x onerror='window.lost = 2'>";
  const escaped = evil.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll("'", "&apos;");
  const text = readFileSync(join(root, "robots/scara.urdf"), "utf8").replace(/(name|link|joint)="/g, `$1="${escaped}`);
  const [urdf, file] = [join(output, "hostile.urdf"), join(output, "hostile.html")];
  writeFileSync(urdf, text);
  run("show", urdf, "-o", file);
  const page = await browser.open(pathToFileURL(file).href, WIDE);
  check((await page.ask(`document.querySelector("#robot").textContent`)).startsWith(evil), "the name is not shown");
  check((await page.ask(`document.querySelectorAll("img").length`)) === 0, "a name was parsed as HTML");
  check(page.complaints.length === 0, page.complaints.join("; "));
  await page.ask(`(() => {
    const script = document.createElement("script");
    script.textContent = "window.lost = 3";
    document.body.append(script);
    const image = document.createElement("div");
    image.innerHTML = ${JSON.stringify(evil)};
    document.body.append(image);
  })()`);
  await new Promise((done) => setTimeout(done, 300));
  check((await page.ask("window.lost")) === undefined, "a script was run");
  check(page.complaints.some((complaint) => /Content Security Policy/.test(complaint)), "the Content Security Policy blocked nothing");
}

// Pictures for the documentation.
async function pictures(browser) {
  const look = async (name, size, steps, path) => {
    const page = await browser.open(pathToFileURL(join(output, `${name}.html`)).href, size);
    await steps(page);
    await new Promise((done) => setTimeout(done, 500));
    await page.picture(join(output, path));
  };
  const frames = (value) => `(() => { const choice = document.querySelector("#frames"); choice.value = "${value}"; choice.dispatchEvent(new Event("change")); })()`;
  const openAt = async (page, own, name) => {
    const card = `[data-function="${own}"]`;
    await page.ask(`document.querySelector('${card}').open = true`);
    await page.until(`document.querySelector('${card} .code .d') !== null`);
    if (name) await page.click(`${card} .d[data-n$="${name}"]`);
  };
  await look("panda", WIDE, async (page) => {
    await page.ask("homogen.move([0.4, -0.5, 0.2, -2.0, 0.3, 1.8, 0.6])");
    await page.ask(`document.querySelector("#moving").click()`);
    await page.ask(frames("0"));
    await openAt(page, "inverse_dynamics", "w_0_3_in_3_x");
    await page.mouse("mouseMoved", { x: 5, y: 5 });
  }, "panda.png");
  await look("quadruped", { ...WIDE, dark: true }, async (page) => {
    await page.ask("homogen.move([0, 0, 0.04, 0.06, 0.1, 0.15, 0.98, 0.2, 0.7, -1.3, -0.2, 0.3, -1.1, 0.1, 0.9, -1.5, -0.2, 0.6, -1.3])");
    await page.ask(frames("described"));
    await page.click("#whole");
    await page.mouse("mouseMoved", { x: 5, y: 5 });
  }, "quadruped_dark.png");
  await look("panda", PHONE, async (page) => {
    await page.ask("homogen.move([0.4, -0.5, 0.2, -2.0, 0.3, 1.8, 0.6])");
  }, "panda_phone.png");
}

const browser = new Browser(chromium);
try {
  for (const robot of ROBOTS) await inBrowser(browser, robot);
  await hostile(browser);
  await pictures(browser);
  console.log(`${checks} checks passed`);
} finally {
  await browser.close();
}
