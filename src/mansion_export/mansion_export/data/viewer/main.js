// The page: floors, choices, labels, what is pointed at. Draws only when something has changed.

const byId = (id) => document.getElementById(id);
const NARROW = 640;

function start(building) {
  const canvas = byId("view");
  const renderer = new Renderer(canvas, building);
  const camera = new Camera(building);
  const labels = new Labels(building, byId("labels"));
  const every = building.floors.map((floor) => floor.number);
  const shown = new Set(every);
  let chosen = 0;
  let waiting = false;
  let last = null;

  const redraw = () => {
    if (!waiting) {
      waiting = true;
      requestAnimationFrame(paint);
    }
  };

  const spread = () => Number(byId("spread").value);
  const panel = () => (document.body.classList.contains("folded") || innerWidth < NARROW ? 0 : (byId("panel").offsetWidth + 12) / canvas.clientWidth);
  const aspect = () => canvas.clientWidth / Math.max(canvas.clientHeight, 1);

  function visible() {
    const floors = building.floors.filter((floor) => shown.has(floor.number));
    floors.forEach((floor, i) => (floor.lift = floor.elevation + i * spread()));
    return floors;
  }

  function extent() {
    const box = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
    for (const floor of visible().length ? visible() : building.floors) {
      for (let i = 0; i < 3; i++) {
        const rise = i === 1 ? floor.lift - floor.elevation : 0;
        box.low[i] = Math.min(box.low[i], floor.low[i] + rise);
        box.high[i] = Math.max(box.high[i], floor.high[i] + rise);
      }
    }
    return box;
  }

  function options() {
    const hidden = new Set();
    if (!byId("ceilings").checked) hidden.add("ceiling");
    if (!byId("objects").checked) hidden.add("objects");
    const cut = Number(byId("cut").value);
    return { camera: camera.matrix(extent(), aspect(), panel()), eye: camera.toward(), hidden, cut: cut >= 5 ? 1e9 : cut, chosen };
  }

  function paint() {
    waiting = false;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const floors = visible();
    last = options();
    renderer.draw(floors, last);
    const top = Math.max(...shown);
    const roofed = byId("ceilings").checked && camera.elevation > 0;
    const stacked = spread() < 2;
    labels.place(last.camera, canvas, (floor) => byId("names").checked && !roofed && shown.has(floor.number) && (!stacked || floor.number === top));
  }

  function frame() {
    camera.fit(extent(), aspect(), panel());
    camera.touched = false;
    redraw();
  }

  // A view that the user has chosen stays, at the height of the floors shown; else the floors fill the window.
  function show(numbers) {
    const before = extent();
    shown.clear();
    numbers.forEach((number) => shown.add(number));
    for (const row of byId("floors").children) {
      const number = Number(row.dataset.floor);
      row.querySelector("input").checked = shown.has(number);
      row.querySelector("button").classList.toggle("only", shown.size === 1 && shown.has(number));
    }
    tell(0);
    if (camera.touched) camera.center[1] += extent().high[1] - before.high[1];
    else frame();
    redraw();
  }

  function tell(number) {
    chosen = number;
    const item = number ? describe(building, building.items[number - 1]) : null;
    byId("picked").hidden = !item;
    byId("picked_name").textContent = item ? item.name : "";
    byId("picked_where").textContent = item ? item.where : "";
    byId("picked_size").textContent = item ? item.size : "";
    byId("picked_id").textContent = item ? item.id : "";
    redraw();
  }

  function under(x, y) {
    const ratio = canvas.width / canvas.clientWidth;
    return renderer.pick(visible(), last || options(), Math.round(x * ratio), Math.round(y * ratio));
  }

  const leave = () => (byId("tip").hidden = true);
  function hover(x, y) {
    const number = under(x, y);
    const tip = byId("tip");
    tip.hidden = !number;
    if (!number) return;
    const { name, where } = describe(building, building.items[number - 1]);
    tip.textContent = where ? `${name} · ${where}` : name;
    const left = Math.min(x + 14, innerWidth - tip.offsetWidth - 8);
    tip.style.transform = `translate(${left}px, ${Math.min(y + 16, innerHeight - 34)}px)`;
  }

  function approach(x, y) {
    const number = under(x, y);
    if (!number) return;
    const { low, high, floor } = building.items[number - 1];
    const rise = floor.lift - floor.elevation;
    const [from, to] = [[...low], [...high]];
    [from[1], to[1]] = [low[1] + rise, high[1] + rise];
    const grow = Math.max(0, 1.2 - Math.hypot(...subtract(to, from)) / 2);
    for (let i = 0; i < 3; i++) [from[i], to[i]] = [from[i] - grow, to[i] + grow];
    camera.fit({ low: from, high: to }, aspect(), panel());
    camera.touched = true;
    redraw();
  }

  function key(name) {
    const step = { PageUp: 1, PageDown: -1 }[name];
    if (/^[0-9]$/.test(name)) show(name === "0" ? every : every.filter((n) => n === Number(name)));
    else if (step) show([every[Math.min(Math.max(every.indexOf(shown.size === 1 ? [...shown][0] : every[step > 0 ? 0 : every.length - 1]) + (shown.size === 1 ? step : 0), 0), every.length - 1)]]);
    else if (name === "Escape") tell(0);
    else return false;
    return true;
  }

  for (const floor of building.floors) {
    const row = document.createElement("div");
    row.className = "floor";
    row.dataset.floor = floor.number;
    const box = document.createElement("input");
    box.type = "checkbox";
    box.ariaLabel = `Show ${floor.title}`;
    box.onchange = () => show(every.filter((n) => (n === floor.number ? box.checked : shown.has(n))));
    const only = document.createElement("button");
    only.textContent = floor.title;
    only.title = "Show this floor alone";
    only.onclick = () => show([floor.number]);
    row.append(box, only);
    byId("floors").append(row);
  }
  const several = building.floors.length > 1;
  for (const id of ["all_floors", "spread_floors"]) byId(id).hidden = !several;
  byId("floors").hidden = !several;
  byId("all").onclick = () => show(every);
  byId("above").onclick = () => { camera.above(); frame(); };
  byId("reset").onclick = () => { camera.reset(); show(every); };
  byId("fold").onclick = () => { document.body.classList.toggle("folded"); if (!camera.touched) frame(); redraw(); };
  byId("unfold").onclick = byId("fold").onclick;
  for (const id of ["spread", "cut", "ceilings", "objects", "names"]) {
    byId(id).oninput = () => {
      const cut = Number(byId("cut").value);
      byId("cut_value").textContent = cut >= 5 ? "full height" : `${cut.toFixed(2)} m`;
      if (id === "spread" && !camera.touched) frame();
      redraw();
    };
  }
  byId("cut").oninput();
  document.body.classList.toggle("folded", innerWidth < NARROW);
  const pick = (x, y) => {
    tell(under(x, y));
    if (document.body.classList.contains("folded")) hover(x, y);
  };
  listen(canvas, camera, { redraw, hover, leave, approach, key, pick });
  addEventListener("resize", () => (camera.touched ? redraw() : frame()));
  show(every);
  renderer.loadPictures(building).then(redraw);
  byId("loading").remove();
  window.mansion = { building, camera, show, frame, redraw, tell, under };
}

unpack(byId("model").textContent)
  .then((buffer) => start(readBuilding(buffer)))
  .catch((error) => {
    byId("loading").hidden = true;
    byId("fault").hidden = false;
    byId("fault").textContent = `The building cannot be shown: ${error.message}`;
  });
