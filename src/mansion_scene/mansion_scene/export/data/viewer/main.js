// The page: orbit camera, floors, labels, picking. Draws only when something has changed.

const byId = (id) => document.getElementById(id);

function start(building) {
  const canvas = byId("view");
  const renderer = new Renderer(canvas, building);
  const shown = new Set(building.floors.map((floor) => floor.number));
  const middle = [0, 1, 2].map((i) => (building.low[i] + building.high[i]) / 2);
  const size = Math.hypot(...subtract(building.high, building.low));
  const eye = { azimuth: -0.6, elevation: 0.75, distance: 1.45 * size, center: [...middle] };
  const home = JSON.stringify(eye);
  let chosen = 0;
  let waiting = false;
  let last = null;

  const labels = building.floors.flatMap((floor) => floor.labels.map((label) => {
    const box = document.createElement("div");
    box.textContent = label.lines[0];
    const area = document.createElement("span");
    area.textContent = label.lines.slice(1).join(" ");
    box.append(area);
    byId("labels").append(box);
    return { floor, at: label.at, box };
  }));

  const redraw = () => {
    if (!waiting) {
      waiting = true;
      requestAnimationFrame(paint);
    }
  };

  function options() {
    const { azimuth, elevation, distance, center } = eye;
    const toward = [Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation)];
    const place = [0, 1, 2].map((i) => center[i] + distance * toward[i]);
    const projection = perspective(0.7, canvas.width / canvas.height, distance / 200, distance * 4 + 4 * size);
    const hidden = new Set();
    if (!byId("ceilings").checked) hidden.add("ceiling");
    if (!byId("objects").checked) hidden.add("objects");
    const cut = Number(byId("cut").value);
    return { camera: multiply(projection, lookAt(place, center, [0, 1, 0])), eye: toward, hidden, cut: cut >= 5 ? 1e9 : cut, chosen };
  }

  function visible() {
    const floors = building.floors.filter((floor) => shown.has(floor.number));
    const spread = Number(byId("spread").value);
    floors.forEach((floor, i) => (floor.lift = floor.elevation + i * spread));
    return floors;
  }

  function paint() {
    waiting = false;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    last = options();
    renderer.draw(visible(), last);
    placeLabels(last.camera);
  }

  function placeLabels(camera) {
    const taken = [];
    const top = Math.max(...shown);
    const covered = Number(byId("spread").value) < 2;
    for (const { floor, at, box } of labels) {
      let fits = byId("names").checked && shown.has(floor.number) && !(covered && floor.number !== top);
      if (fits) {
        const [x, y, , w] = transform(camera, [at[0], at[1] + floor.lift, at[2]]);
        const [px, py] = [((x + 1) / 2) * canvas.clientWidth, ((1 - y) / 2) * canvas.clientHeight];
        const half = 4 + 3.4 * box.firstChild.textContent.length;
        fits = w > 0 && !taken.some(([a, b, c]) => Math.abs(a - px) < c + half && Math.abs(b - py) < 32);
        if (fits) {
          taken.push([px, py, half]);
          box.style.transform = `translate(${px.toFixed(1)}px, ${py.toFixed(1)}px) translate(-50%, -50%)`;
        }
      }
      box.style.display = fits ? "" : "none";
    }
  }

  function show(numbers) {
    shown.clear();
    numbers.forEach((number) => shown.add(number));
    const floors = building.floors.filter((floor) => shown.has(floor.number));
    if (floors.length) {
      const heights = floors.map((floor) => floor.elevation);
      eye.center[1] = (Math.min(...heights) + Math.max(...heights)) / 2 + 1.4;
    }
    for (const row of byId("floors").children) {
      const number = Number(row.dataset.floor);
      row.querySelector("input").checked = shown.has(number);
      row.querySelector("button").classList.toggle("only", shown.size === 1 && shown.has(number));
    }
    redraw();
  }

  const every = building.floors.map((floor) => floor.number);
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
    only.onclick = () => show([floor.number]);
    row.append(box, only);
    byId("floors").append(row);
  }
  byId("all").onclick = () => show(every);
  byId("none").onclick = () => show([]);
  byId("above").onclick = () => { eye.elevation = 1.55; eye.azimuth = 0; redraw(); };
  byId("reset").onclick = () => { Object.assign(eye, JSON.parse(home)); show(every); };
  for (const id of ["spread", "cut", "ceilings", "objects", "names"]) {
    byId(id).oninput = () => {
      const cut = Number(byId("cut").value);
      byId("cut_value").textContent = cut >= 5 ? "full height" : `${cut.toFixed(2)} m`;
      redraw();
    };
  }
  byId("cut").oninput();
  listen(canvas, eye, redraw, pickAt);
  addEventListener("keydown", (event) => {
    if (event.target.tagName === "INPUT") return;
    if (/^[0-9]$/.test(event.key)) show(event.key === "0" ? every : every.filter((n) => n === Number(event.key)));
  });

  function pickAt(x, y) {
    const ratio = canvas.width / canvas.clientWidth;
    const number = renderer.pick(visible(), last || options(), Math.round(x * ratio), Math.round(y * ratio));
    chosen = number;
    byId("picked").textContent = number ? building.names[number - 1] : "Click something to see its id.";
    redraw();
  }

  addEventListener("resize", redraw);
  show(every);
  window.mansion = { building, eye, show, redraw, pickAt };
}

function listen(canvas, eye, redraw, pick) {
  const touches = new Map();
  let moved = 0;
  canvas.oncontextmenu = (event) => event.preventDefault();
  canvas.onpointerdown = (event) => {
    canvas.setPointerCapture(event.pointerId);
    touches.set(event.pointerId, [event.clientX, event.clientY]);
    moved = 0;
  };
  canvas.onpointerup = (event) => {
    if (touches.size === 1 && moved < 4) pick(event.clientX, event.clientY);
    touches.delete(event.pointerId);
  };
  canvas.onpointercancel = (event) => touches.delete(event.pointerId);
  canvas.onpointermove = (event) => {
    const before = touches.get(event.pointerId);
    if (!before) return;
    const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]];
    const spread = () => {
      const [a, b] = [...touches.values()];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    };
    const old = touches.size === 2 ? spread() : 0;
    touches.set(event.pointerId, [event.clientX, event.clientY]);
    moved += Math.abs(dx) + Math.abs(dy);
    if (touches.size === 2) {
      eye.distance *= old / Math.max(spread(), 1);
      move(eye, dx / 2, dy / 2, canvas);
    } else if (event.buttons === 2 || event.shiftKey) {
      move(eye, dx, dy, canvas);
    } else {
      eye.azimuth -= dx * 0.006;
      eye.elevation = Math.min(1.55, Math.max(-0.2, eye.elevation + dy * 0.006));
    }
    redraw();
  };
  canvas.onwheel = (event) => {
    event.preventDefault();
    eye.distance = Math.max(1, eye.distance * Math.exp(event.deltaY * 0.0012));
    redraw();
  };
}

function move(eye, dx, dy, canvas) {
  const step = (0.73 * eye.distance) / canvas.clientHeight;
  const [c, s] = [Math.cos(eye.azimuth), Math.sin(eye.azimuth)];
  const along = Math.sin(eye.elevation);
  eye.center[0] -= step * (dx * c + dy * s * along);
  eye.center[2] -= step * (-dx * s + dy * c * along);
  eye.center[1] += step * dy * Math.cos(eye.elevation);
}

unpack(byId("model").textContent)
  .then((buffer) => start(readBuilding(buffer)))
  .catch((error) => {
    byId("fault").hidden = false;
    byId("fault").textContent = `The building cannot be shown: ${error.message}`;
  });
