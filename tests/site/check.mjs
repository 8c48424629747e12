// Checks the page of `homogen site` in a browser.
//
// In: the program `homogen`, Chromium, an output folder with the site in `served`. Out: pictures in that folder, sizes and
// times on standard output, or an error for the first check that fails.

import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { gzipSync } from "node:zlib";
import { Browser } from "../show/browser.mjs";
import { serve } from "./server.mjs";

const [homogen, chromium, output] = process.argv.slice(2);
const root = resolve(import.meta.dirname, "../..");
const WIDE = { width: 1440, height: 900 };
const SIZES = [["phone", { width: 375, height: 812, ratio: 2, touch: true }], ["wide", WIDE], ["large", { width: 2560, height: 1440 }]];

// Options of robots with several ends.
const OPTIONS = { "panda_class.urdf": [["tip", "link8"]], "quadruped.urdf": [["floating", ""], ["tip", "fl_foot"]] };

let checks = 0;
function check(holds, what) {
  checks += 1;
  if (!holds) throw new Error(what);
}

const run = (words, folder = root) => execFileSync(homogen, words, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] });

// Drops a file on the page.
const drop = (page, name, text) => page.ask(`(() => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([${JSON.stringify(text)}], ${JSON.stringify(name)}));
  document.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
})()`);

// Text that differs before and after an answer.
const answered = `document.querySelector("#name").textContent === NAME && (site.error() !== null || site.values()?.mass_matrix)`;
const until = (page, name) => page.until(answered.replace("NAME", JSON.stringify(name)));

// Values of a moving robot equal those of `homogen eval`, to the last bit.
async function values(page, name, file, options) {
  const given = await page.ask(`(() => {
    const sway = (size, step) => homogen.given().qd.map((_, k) => size * Math.sin(step * (k + 1)));
    homogen.move(homogen.q().map((entry, k) => entry + 0.3 * Math.sin(k + 1)));
    homogen.give({ qd: sway(0.7, 2), qdd: sway(1.3, 3) });
    const { q, qd, qdd } = homogen.given();
    return { q, qd, qdd };
  })()`);
  const state = join(output, "states.json");
  writeFileSync(state, JSON.stringify({ states: [given] }));
  const words = options.flatMap(([option, value]) => (value === "" ? [`--${option}`] : [`--${option}`, value]));
  const expected = {};
  for (const own of ["gravity", "inverse_dynamics", "mass_matrix"]) {
    expected[own] = JSON.parse(run(["eval", file, ...words, "--function", own, "--states", state, "--format", "json"])).results[0];
  }
  const text = JSON.stringify(expected);
  // The page may still show the state before.
  const seen = `JSON.stringify({ gravity: site.values().gravity, inverse_dynamics: site.values().inverse_dynamics, mass_matrix: site.values().mass_matrix })`;
  const end = performance.now() + 10_000;
  let last = null;
  while ((last = await page.ask(seen)) !== text && performance.now() < end) await new Promise((done) => setTimeout(done, 30));
  check(last === text, `${name}: ${last} on the page, ${text} by eval`);
}

async function shipped(browser, address) {
  const files = readdirSync(join(root, "robots")).filter((file) => /\.(urdf|dh|xml|sdf|xacro)$/.test(file));
  for (const file of files) {
    const page = await browser.open(address, WIDE);
    await page.ask("site.times()");
    await drop(page, file, readFileSync(join(root, "robots", file), "utf8"));
    await until(page, file);
    check((await page.ask("site.error()")) === null, `${file}: ${await page.ask("site.error()")}`);
    const options = OPTIONS[file] || [];
    if (options.length) {
      await page.ask(`site.take(${JSON.stringify(file)}, ${JSON.stringify(readFileSync(join(root, "robots", file), "utf8"))}, ${JSON.stringify(options)})`);
      await until(page, file);
    }
    await values(page, file, join("robots", file), options);
    check(page.complaints.length === 0, `${file}: ${page.complaints.join("; ")}`);
    await page.send("Page.close");
  }
  console.log(`${files.length} robots of the repository have the values of homogen eval`);
}

// Files in each language equal those of the command that the page shows.
async function languages(browser, address) {
  const page = await browser.open(`${address}#robot=two_link.urdf`, WIDE);
  await page.until("site.settled()");
  check((await page.ask(`document.querySelectorAll(".lacking").length`)) === 0, "a function of two links is not available");
  for (const [index, title] of ["Rust", "C99", "Python", "LLVM IR"].entries()) {
    await page.ask(`document.querySelector("#files .tabs button:nth-child(${index + 1})").click()`);
    const language = ["", "--language c", "--language python", "--language llvm"][index];
    await page.until(`!document.querySelector(".files").classList.contains("busy") && document.querySelector("#command")?.textContent.includes(${JSON.stringify(language)})`);
    const command = await page.ask(`document.querySelector("#command").textContent`);
    const words = command.split(" ");
    check(words[0] === "homogen" && !command.includes("'"), `${command} is not simple`);
    const folder = join(output, "generated");
    execFileSync("mkdir", ["-p", folder]);
    execFileSync("cp", [join(root, "robots/two_link.urdf"), folder]);
    run(words.slice(1), folder);
    const files = await page.ask(`[...document.querySelectorAll(".file")].map((file) => [file.querySelector("a").download, file.querySelector("pre").textContent])`);
    check(files.length === (title === "C99" ? 2 : 1), `${title}: ${files.length} files`);
    for (const [name, text] of files) {
      check(readFileSync(join(folder, name), "utf8") === text, `${title}: ${name} differs from that of ${command}`);
    }
  }
}

// Messages are under the words that caused them, and go when the text is corrected.
async function mistakes(browser, address) {
  const page = await browser.open(address, WIDE);
  const text = readFileSync(join(root, "robots/two_link.urdf"), "utf8");
  const wrong = text.replace('<axis xyz="', '<axis xyz="0 0 0" was="');
  await drop(page, "wrong.urdf", wrong);
  await until(page, "wrong.urdf");
  const word = await page.ask(`document.querySelector(".message.error .word")?.textContent`);
  check(/axis|xyz|0 0 0/.test(word || ""), `the message is under ${word}`);
  await page.ask(`(() => { const text = document.querySelector("#text-of-robot"); text.value = ${JSON.stringify(text)}; text.dispatchEvent(new Event("input", { bubbles: true })); })()`);
  await page.until("site.error() === null && site.values()?.mass_matrix");
  // Options that contradict the file.
  await page.ask(`(() => { const own = document.querySelector("#option-lock"); own.value = "nowhere"; own.dispatchEvent(new Event("change")); })()`);
  await page.until("site.error() !== null");
  check(/nowhere/.test(await page.ask("site.error()")), "the error does not name the joint");
  check(page.complaints.length === 0, page.complaints.join("; "));
}

// Hostile files end in a message; nothing of them runs, and the page takes the next file.
async function hostile(browser, address) {
  const page = await browser.open(address, WIDE);
  const good = readFileSync(join(root, "robots/scara.urdf"), "utf8");
  const evil = "</script><script>window.lost = 1</script><img src=x onerror='window.lost = 2'>";
  const escaped = evil.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll("'", "&apos;");
  await drop(page, "names.urdf", good.replace(/(name|link|joint)="/g, `$1="${escaped}`));
  await until(page, "names.urdf");
  check((await page.ask(`document.querySelector("#robot").textContent`)).startsWith(evil), "the name is not shown");
  check((await page.ask(`document.querySelectorAll("img, #view-of-robot script").length`)) === 0, "a name was parsed as HTML");
  const nested = (count) => `"<robot>" + "<link name='a'>".repeat(${count})`;
  const bomb = `'<!DOCTYPE r [<!ENTITY a "' + "b".repeat(100) + '">' + Array.from({ length: 20 }, (_, k) => '<!ENTITY a' + k + ' "' + ("&a" + (k || "") + ";").repeat(10) + '">').join("") + ']><robot name="&a19;"/>'`;
  const macros = `'<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="m" params=""><xacro:m/></xacro:macro><xacro:m/></robot>'`;
  for (const [name, made] of [["nested.urdf", nested(300_000)], ["closed.urdf", `"<robot name='r'>" + "<link name='a'>".repeat(100_000) + "</link>".repeat(100_000) + "</robot>"`], ["entities.urdf", bomb], ["macros.xacro", macros], ["zeros.urdf", `"\\0".repeat(1000)`], ["empty.urdf", `""`]]) {
    await page.ask(`site.take(${JSON.stringify(name)}, ${made})`);
    await page.until(`document.querySelector("#name").textContent === ${JSON.stringify(name)} && site.error() !== null`);
    console.log(`${name}: ${(await page.ask("site.error()")).replace(/.*Error/s, "").slice(0, 140)}`);
  }
  await page.ask(`(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([new Uint8Array(65 << 20)], "large.urdf"));
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  })()`);
  await page.until(`/64 MB/.test(site.error())`);
  await drop(page, "good.urdf", good);
  await until(page, "good.urdf");
  check((await page.ask("site.error()")) === null, "the page does not recover");
  check((await page.ask("window.lost")) === undefined, "a script was run");
  check(page.complaints.length === 0, page.complaints.join("; "));
}

// A link has the robot, its options and the configuration; a typed number is one of it.
async function links(browser, address) {
  const page = await browser.open(`${address}#robot=panda_class.urdf&-tip=link8&q=0.1,-0.2,0.3,-0.4,0.5,0.6,-0.7`, WIDE);
  await page.until("site.values()?.mass_matrix");
  check((await page.ask("homogen.q().join()")) === "0.1,-0.2,0.3,-0.4,0.5,0.6,-0.7", "the configuration of the link");
  await page.ask(`(() => { const typed = document.querySelector(".sliders .typed"); typed.value = "1.5 rad"; typed.dispatchEvent(new Event("change")); })()`);
  check((await page.ask("homogen.q()[0]")) === 1.5, "a typed number");
  await page.until(`location.hash.includes("q=1.5,")`);
  // A plot of a torque over the range of a joint.
  await page.ask(`document.querySelector(".plot").parentElement.open = true`);
  await page.until(`document.querySelector(".plot polyline")?.getAttribute("points").split(" ").length === 73`);
  await page.until(`/joint2 from/.test(document.querySelector(".plot").getAttribute("aria-label"))`);
}

async function times(browser, address) {
  const module = readFileSync(join(output, "served/homogen.wasm"));
  const packed = gzipSync(module, { level: 9 }).length;
  console.log(`module: ${(module.length / 1e6).toFixed(2)} MB, ${(packed / 1e6).toFixed(2)} MB compressed`);
  check(packed < 2e6, "the module is larger than 2 MB compressed");
  for (const sample of ["panda_class.urdf", "quadruped.urdf", "humanoid.urdf"]) {
    const page = await browser.open(address, WIDE);
    await page.ask(`document.querySelector('[data-sample="${sample}"]').click()`);
    await page.until(sample === "humanoid.urdf" ? "site.times().values" : "site.settled()");
    const { robot, first, values: all, all: every } = await page.ask("site.times()");
    const said = (time) => (time === undefined ? "—" : `${(time / 1000).toFixed(2)} s`);
    console.log(`${sample}: shown after ${said(robot)}, first function ${said(first)}, torques and mass matrix ${said(all)}, all functions ${said(every)}; opened in ${page.took.toFixed(0)} ms`);
    await page.send("Page.close");
  }
}

// Pictures at three widths, light and dark; nothing is wider than the page.
async function pictures(browser, address) {
  for (const [name, size] of SIZES) {
    for (const dark of [false, true]) {
      const look = `${name}${dark ? "_dark" : ""}`;
      const start = await browser.open(address, { ...size, dark });
      await start.picture(join(output, `start_${look}.png`));
      const page = await browser.open(`${address}#robot=panda_class.urdf&-tip=link8&q=0.4,-0.5,0.2,-2.0,0.3,1.8,0.6`, { ...size, dark });
      await page.until("site.values()?.mass_matrix && document.querySelector('#command')");
      await page.picture(join(output, `panda_${look}.png`));
      for (const part of ["values", "files"]) {
        await page.ask(`document.querySelector("#${part}").scrollIntoView({ behavior: "instant" })`);
        await new Promise((done) => setTimeout(done, 300));
        await page.picture(join(output, `panda_${part}_${look}.png`));
      }
      for (const one of [start, page]) {
        const width = await one.ask("document.documentElement.scrollWidth");
        check(width <= size.width, `${look}: ${width} px wide`);
        check(one.complaints.length === 0, `${look}: ${one.complaints.join("; ")}`);
        await one.send("Page.close");
      }
    }
  }
}

const server = await serve(join(output, "served"));
const browser = new Browser(chromium);
try {
  await times(browser, server.address);
  await shipped(browser, server.address);
  await languages(browser, server.address);
  await mistakes(browser, server.address);
  await links(browser, server.address);
  await hostile(browser, server.address);
  await pictures(browser, server.address);
  const known = /^\/(|site\.css|site\.js|worker\.js|homogen\.wasm|robots\/[\w.]+)$/;
  const other = server.requested.filter((path) => !known.test(path));
  check(other.length === 0, `requests: ${other.join(", ")}`);
  console.log(`${checks} checks passed`);
} finally {
  await browser.close();
  server.close();
}
