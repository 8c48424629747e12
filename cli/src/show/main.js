// Shows the robot of a page of its own. `window.homogen` is an interface for scripts.

const data = JSON.parse(by("data").textContent);
window.homogen = present(data);
by("foot").append("Written by ", el("code", {}, `homogen show ${data.version}`), ". One file, without network requests.");
