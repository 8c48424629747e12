// Options of the engine as fields: the table of the command line.

const GROUPS = [["scope", "Part of the robot"], ["robot", "Robot and computation"], ["functions", "Functions"], ["file", "File"]];

// The options that stand in the bar.
const IN_BAR = ["base", "tip", "floating"];

// The fields; `changed` is called when a value changes. `pairs` returns names and values as the engine takes them.
function optionFields(table, changed) {
  const fields = table.filter(({ name }) => !IN_BAR.includes(name)).map((option) => {
    const id = `option-${option.name}`;
    const input = option.switch
      ? el("input", { type: "checkbox", id, onchange: changed })
      : el("input", { type: "text", id, placeholder: option.value + (option.repeats && !option.value.endsWith("…") ? "; …" : ""), spellcheck: "false", autocapitalize: "off", onchange: changed });
    const row = el("div", { class: "option" },
      el("label", { for: id }, el("code", {}, `--${option.name}`)), input, el("small", {}, option.help));
    return { option, input, row };
  });
  const pairs = () => fields.flatMap(({ option, input }) => {
    if (option.switch) return input.checked ? [[option.name, ""]] : [];
    const values = option.repeats ? input.value.split(";") : [input.value];
    return values.map((value) => value.trim()).filter(Boolean).map((value) => [option.name, value]);
  });
  const set = (given) => {
    for (const { option, input } of fields) {
      const own = given.filter(([name]) => name === option.name).map(([, value]) => value);
      if (option.switch) input.checked = own.length > 0;
      else input.value = own.join("; ");
    }
  };
  const section = GROUPS.map(([group, title]) => {
    const own = fields.filter(({ option }) => option.group === group);
    return own.length ? el("fieldset", {}, el("legend", {}, title), own.map(({ row }) => row)) : null;
  });
  return { section: section.filter(Boolean), pairs, set };
}
