// Values of functions in the present state: torques as bars against effort limits, the mass matrix and its inverse as heat
// maps.

// The functions whose values are shown, where the robot has them; the inverse takes longest.
const VALUED = ["gravity", "inverse_dynamics", "mass_matrix", "mass_matrix_inverse"];

// The section of a robot with functions; `change` is called with new rates and accelerations. `show` takes the results
// of each valued function by name, `set` rates and accelerations that were changed elsewhere.
function valueSection(data, change) {
  const { velocities } = data.skeleton;
  const has = (name) => data.functions.some((own) => own.name === name);
  const given = { qd: velocities.map(() => 0), qdd: velocities.map(() => 0) };
  const fields = { qd: [], qdd: [] };
  const field = (variable, k, unit) => {
    const input = el("input", { class: "typed", inputmode: "decimal", value: "0", "aria-label": `${variable === "qd" ? "Velocity" : "Acceleration"} of ${velocities[k].name} in ${unit}`, onchange: () => {
      const wanted = Number(input.value.replace("−", "-").replace(",", "."));
      if (Number.isFinite(wanted)) given[variable][k] = wanted;
      input.value = short(given[variable][k], 6);
      change({ qd: [...given.qd], qdd: [...given.qdd] });
    } });
    fields[variable].push(input);
    return input;
  };
  const set = (rates) => {
    for (const variable of ["qd", "qdd"]) {
      rates[variable].forEach((rate, k) => {
        given[variable][k] = rate;
        fields[variable][k].value = short(rate, 4);
      });
    }
  };
  const rows = velocities.map((entry, k) => {
    const own = { gravity: el("span", { class: "gauge gravity" }), all: el("span", { class: "gauge all" }) };
    const track = el("span", { class: "track" }, own.gravity, own.all);
    const [gravity, all] = [el("td", { class: "number" }, "…"), el("td", { class: "number strong" }, "…")];
    const per = entry.kind === "translation" ? "m" : "rad";
    const limit = data.efforts[k];
    const row = el("tr", {},
      el("td", {}, named(entry.name)), el("td", { class: "bars" }, track), all, gravity,
      el("td", { class: "number" }, limit === null ? "—" : `${short(limit)} ${entry.kind === "translation" ? "N" : "N m"}`),
      el("td", { class: "number" }, field("qd", k, `${per}/s`)), el("td", { class: "number" }, field("qdd", k, `${per}/s²`)));
    return { own, gravity, all, row, track, limit };
  });
  const torques = has("inverse_dynamics") ? [
    el("div", { class: "title" }, el("h2", { id: "values-title" }, "Torques"),
      el("div", { class: "buttons" }, el("button", { type: "button", onclick: () => {
        set({ qd: velocities.map(() => 0), qdd: velocities.map(() => 0) });
        change({ qd: [...given.qd], qdd: [...given.qdd] });
      } }, "At rest"))),
    el("div", { class: "table", tabindex: "0", role: "region", "aria-label": "Torques" }, el("table", { class: "torques" },
      el("thead", {}, el("tr", {}, ["joint", "", "τ", "gravity", "limit", "q̇ / s⁻¹", "q̈ / s⁻²"].map((text, k) => el("th", { scope: "col", class: k > 1 ? "number" : null }, text)))),
      el("tbody", {}, rows.map(({ row }) => row)))),
    el("p", { class: "small" }, "τ is that of inverse dynamics for these velocities q̇ and accelerations q̈, in N m or N. A full bar is the effort limit of the joint; without a limit, the largest τ of all."),
  ] : [];
  const [mass, inverse] = [matrixMap("mass_matrix", "Mass matrix M"), matrixMap("mass_matrix_inverse", "Its inverse M⁻¹")];
  const maps = [mass, inverse].filter(({ name }) => has(name));
  const section = [...torques, maps.length ? el("details", { class: "part", open: velocities.length <= 12 },
    el("summary", {}, el("h3", {}, "Mass matrix")), el("div", { class: "beside" }, maps.map(({ box }) => box))) : null].filter(Boolean);
  const show = ({ gravity, inverse_dynamics: all, ...matrices }) => {
    const largest = Math.max(...(all || []).map(Math.abs), ...(gravity || []).map(Math.abs), 1e-12);
    const said = alike(largest, 5);
    rows.forEach(({ own, gravity: first, all: second, track, limit }, k) => {
      const gauge = (bar, value) => {
        const share = Math.max(-1, Math.min(1, value / (limit || largest)));
        bar.style.left = `${50 + Math.min(0, share) * 50}%`;
        bar.style.width = `${Math.abs(share) * 50}%`;
      };
      if (gravity) {
        first.textContent = said(gravity[k]);
        first.title = String(gravity[k]);
        gauge(own.gravity, gravity[k]);
      }
      if (!all) return;
      second.textContent = said(all[k]);
      second.title = String(all[k]);
      gauge(own.all, all[k]);
      track.classList.toggle("over", limit !== null && Math.abs(all[k]) > limit);
    });
    for (const { name, heat } of maps) if (matrices[name]) paintHeat(heat, matrices[name], velocities);
  };
  // A function that the robot cannot have, with the reason.
  const lack = (name, reason) => maps.find((map) => map.name === name)?.heat.replaceChildren(el("p", { class: "small" }, reason));
  return { section, show, set, lack };
}

// Writes numbers with the same number of decimals, so many digits of the largest.
function alike(largest, digits) {
  const decimals = Math.max(0, Math.min(8, digits - 1 - Math.floor(Math.log10(largest))));
  return (value) => value.toFixed(decimals).replace(/^-(0\.?0*)$/, "$1").replace("-", "−");
}

// The box of a matrix.
function matrixMap(name, title) {
  const heat = el("div", { class: "heat", id: `heat-${name}` });
  return { name, heat, box: el("div", {}, el("h4", {}, title), heat) };
}

// A matrix as squares, coloured by √|entry|, with numbers where they fit.
function paintHeat(place, rows, names) {
  const largest = Math.max(...rows.flat().map(Math.abs)) || 1;
  const said = alike(largest, 4);
  place.style.setProperty("--columns", String(rows.length));
  place.classList.toggle("dense", rows.length > 12);
  const cells = rows.flatMap((row, i) => row.map((entry, j) => {
    const cell = el("span", { class: entry < 0 ? "negative" : "positive", title: `${names[i].name}, ${names[j].name}: ${short(entry, 6)}`, "data-value": String(entry) },
      rows.length > 12 ? null : said(entry));
    cell.style.setProperty("--share", Math.sqrt(Math.abs(entry) / largest).toFixed(3));
    return cell;
  }));
  place.replaceChildren(...cells);
}
