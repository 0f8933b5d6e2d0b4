// Room names over the picture: large rooms first, small ones without their area or not at all.

class Labels {
  constructor(building, holder) {
    this.all = building.floors.flatMap((floor) => floor.labels.map((label) => {
      const box = document.createElement("div");
      const area = document.createElement("span");
      box.textContent = label.lines[0];
      area.textContent = label.lines.slice(1).join(" ");
      box.append(area);
      holder.append(box);
      const extent = (label.high[0] - label.low[0]) * (label.high[2] - label.low[2]);
      return { ...label, floor, box, extent, widths: null };
    }));
    this.all.sort((a, b) => b.extent - a.extent);
  }

  // Widths are read once and all together: reading one after writing another makes the browser lay out anew each time.
  measure() {
    if (this.all.every((label) => label.widths)) return;
    for (const { box } of this.all) box.style.display = "";
    for (const label of this.all) label.wide = label.box.offsetWidth;
    for (const { box } of this.all) box.classList.add("small");
    for (const label of this.all) label.widths = [label.wide, label.box.offsetWidth];
  }

  place(camera, canvas, shows) {
    this.measure();
    const taken = [];
    const screen = (p) => {
      const [x, y, , w] = transform(camera, p);
      return [((x + 1) / 2) * canvas.clientWidth, ((1 - y) / 2) * canvas.clientHeight, w];
    };
    for (const { floor, at, low, high, box, widths } of this.all) {
      let fits = shows(floor);
      if (fits) {
        const lift = floor.lift;
        const [x, y, w] = screen([at[0], at[1] + lift, at[2]]);
        const corners = [[low[0], low[2]], [high[0], low[2]], [high[0], high[2]], [low[0], high[2]]].map(([a, b]) => screen([a, at[1] + lift, b]));
        const [wide, tall] = [0, 1].map((k) => Math.max(...corners.map((c) => c[k])) - Math.min(...corners.map((c) => c[k])));
        const small = wide < widths[0] + 8 || tall < 54;
        const [half, rise] = [widths[small ? 1 : 0] / 2, small ? 9 : 17];
        fits = w > 0 && wide > 0.8 * widths[1] && tall > 14
          && !taken.some(([a, b, c, d]) => Math.abs(a - x) < c + half + 2 && Math.abs(b - y) < d + rise + 1);
        if (fits) {
          taken.push([x, y, half, rise]);
          box.classList.toggle("small", small);
          box.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
        }
      }
      box.style.display = fits ? "" : "none";
    }
  }
}
