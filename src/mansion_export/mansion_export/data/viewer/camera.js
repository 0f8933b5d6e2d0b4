// The orbit camera: where it looks from, what fits the window beside the panel, and how drags move it.

const STREET = (32 * Math.PI) / 180;
const LENS = 0.5;
const PLAN_LENS = 0.06;

class Camera {
  constructor(building) {
    this.turned = STREET - ((building.turns || 0) * Math.PI) / 2;
    this.reset();
  }

  reset() {
    Object.assign(this, { azimuth: this.turned, elevation: 0.72, lens: LENS, distance: 10, center: [0, 0, 0], touched: false });
  }

  // Straight down, the entrance at the bottom, with next to no perspective, so that it reads like a plan.
  above() {
    const quarter = Math.PI / 2;
    Object.assign(this, { azimuth: Math.round((this.turned - STREET) / quarter) * quarter, elevation: Math.PI / 2 - 1e-4, lens: PLAN_LENS, touched: false });
  }

  toward() {
    const { azimuth, elevation } = this;
    return [Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation)];
  }

  axes() {
    const z = this.toward();
    const x = [Math.cos(this.azimuth), 0, -Math.sin(this.azimuth)];
    return { x, y: cross(z, x), z };
  }

  // Stand as near as shows the whole box in a window of width to height, less the share that the panel takes on the left.
  fit({ low, high }, aspect, panel) {
    const { x, y, z } = this.axes();
    const across = Math.tan(this.lens / 2) * aspect * (1 - panel) * 0.94;
    const tall = Math.tan(this.lens / 2) * 0.9;
    const corners = [...Array(8).keys()].map((n) => [0, 1, 2].map((i) => ((n >> i) & 1 ? high : low)[i]));
    this.center = [0, 1, 2].map((i) => (low[i] + high[i]) / 2);
    for (let round = 0; round < 4; round++) {
      const seen = corners.map((corner) => subtract(corner, this.center)).map((p) => [dot(p, x), dot(p, y), dot(p, z)]);
      this.distance = Math.max(1, ...seen.map(([a, b, c]) => c + Math.max(Math.abs(a) / across, Math.abs(b) / tall)));
      const middle = [0, 1].map((k) => {
        const spots = seen.map((p) => p[k] / (this.distance - p[2]));
        return ((Math.min(...spots) + Math.max(...spots)) / 2) * this.distance;
      });
      for (let i = 0; i < 3; i++) this.center[i] += middle[0] * x[i] + middle[1] * y[i];
    }
  }

  matrix({ low, high }, aspect, panel) {
    const place = this.center.map((c, i) => c + this.distance * this.toward()[i]);
    const depths = [...Array(8).keys()].map((n) => dot(subtract(place, [0, 1, 2].map((i) => ((n >> i) & 1 ? high : low)[i])), this.toward()));
    const near = Math.max(Math.min(...depths) - 1, 0.1, this.distance / 400);
    const projection = perspective(this.lens, aspect, near, Math.max(...depths, near) + 1);
    projection[8] = -panel;
    const { x, y, z } = this.axes();
    return multiply(projection, new Float32Array([
      x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, place), -dot(y, place), -dot(z, place), 1,
    ]));
  }

  turn(dx, dy) {
    this.azimuth -= dx * 0.006;
    this.elevation = Math.min(Math.PI / 2 - 1e-4, Math.max(-0.2, this.elevation + dy * 0.006));
    if (this.lens !== LENS && this.elevation < 1.4) {
      this.distance *= Math.tan(this.lens / 2) / Math.tan(LENS / 2);
      this.lens = LENS;
    }
    this.touched = true;
  }

  // Along the ground, so that what was taken hold of stays below the pointer.
  move(dx, dy, height) {
    const step = (2 * Math.tan(this.lens / 2) * this.distance) / height;
    const [c, s] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const steep = Math.max(Math.sin(this.elevation), 0.3);
    this.center[0] -= step * (dx * c + (dy * s) / steep);
    this.center[2] -= step * (-dx * s + (dy * c) / steep);
    this.touched = true;
  }

  zoom(factor) {
    this.distance = Math.min(1e5, Math.max(LENS / this.lens, this.distance * factor));
    this.touched = true;
  }
}
