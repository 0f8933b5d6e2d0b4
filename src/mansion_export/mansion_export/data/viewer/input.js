// Mouse, touch, pen and keys on the picture.

const REST = 90;

function listen(canvas, camera, act) {
  const touches = new Map();
  let moved = 0;
  let resting = 0;
  canvas.oncontextmenu = (event) => event.preventDefault();
  canvas.onpointerdown = (event) => {
    canvas.setPointerCapture(event.pointerId);
    touches.set(event.pointerId, [event.clientX, event.clientY]);
    if (touches.size === 1) moved = 0;
    act.leave();
  };
  canvas.onpointerup = (event) => {
    if (touches.size === 1 && moved < 6 && event.button === 0) act.pick(event.clientX, event.clientY);
    touches.delete(event.pointerId);
  };
  canvas.onpointercancel = (event) => touches.delete(event.pointerId);
  canvas.onpointerleave = () => {
    clearTimeout(resting);
    act.leave();
  };
  canvas.onpointermove = (event) => {
    const before = touches.get(event.pointerId);
    if (!before) {
      // What lies below the pointer is asked for when it rests: finding it draws the building once more.
      clearTimeout(resting);
      if (event.pointerType === "mouse") resting = setTimeout(() => act.hover(event.clientX, event.clientY), REST);
      return;
    }
    const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]];
    const gap = () => {
      const [a, b] = [...touches.values()];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    };
    const old = touches.size === 2 ? gap() : 0;
    touches.set(event.pointerId, [event.clientX, event.clientY]);
    moved += Math.abs(dx) + Math.abs(dy);
    if (touches.size === 2) {
      camera.zoom(old / Math.max(gap(), 1));
      camera.move(dx / 2, dy / 2, canvas.clientHeight);
    } else if (event.buttons & 6 || event.shiftKey) {
      camera.move(dx, dy, canvas.clientHeight);
    } else {
      camera.turn(dx, dy);
    }
    act.redraw();
  };
  canvas.onwheel = (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 30 : 1;
    camera.zoom(Math.exp(Math.max(-240, Math.min(240, event.deltaY * lines)) * 0.0012));
    act.redraw();
  };
  canvas.ondblclick = (event) => act.approach(event.clientX, event.clientY);
  addEventListener("keydown", (event) => {
    const typing = event.target.tagName === "INPUT" && event.target.type !== "checkbox";
    if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
    const steps = { ArrowLeft: [-24, 0], ArrowRight: [24, 0], ArrowUp: [0, 24], ArrowDown: [0, -24] };
    if (event.key in steps) camera.turn(...steps[event.key]);
    else if (event.key === "+" || event.key === "=") camera.zoom(0.87);
    else if (event.key === "-") camera.zoom(1.15);
    else if (!act.key(event.key)) return;
    event.preventDefault();
    act.redraw();
  });
}
