// Reads the binary glTF that the page carries: floors, groups, instances of each primitive, room labels.

async function unpack(text) {
  const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

function parseGlb(buffer) {
  const view = new DataView(buffer);
  if (view.getUint32(0, true) !== 0x46546c67) throw new Error("this is no binary glTF");
  const length = view.getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 20, length)));
  const start = 28 + length;
  const read = (index) => {
    const accessor = gltf.accessors[index];
    const bytes = gltf.bufferViews[accessor.bufferView];
    const size = { SCALAR: 1, VEC2: 2, VEC3: 3 }[accessor.type];
    const Type = { 5126: Float32Array, 5123: Uint16Array, 5125: Uint32Array }[accessor.componentType];
    return new Type(buffer, start + (bytes.byteOffset || 0) + (accessor.byteOffset || 0), accessor.count * size);
  };
  const picture = (index) => {
    const { bufferView, mimeType } = gltf.images[gltf.textures[index].source];
    const { byteOffset, byteLength } = gltf.bufferViews[bufferView];
    return new Blob([new Uint8Array(buffer, start + (byteOffset || 0), byteLength)], { type: mimeType });
  };
  return { gltf, read, picture };
}

// floors: [{title, number, elevation, low, high, batches: [{primitive, group, matrices, ids}], labels: [...]}]; an id counts in items from 1]
function readBuilding(buffer) {
  const { gltf, read, picture } = parseGlb(buffer);
  const root = gltf.nodes[gltf.scenes[0].nodes[0]];
  const items = [];
  const floors = [];
  for (const index of root.children || []) {
    const node = gltf.nodes[index];
    const elevation = (node.translation || [0, 0, 0])[1];
    const number = parseInt(node.name.split("_").pop(), 10);
    const title = (node.extras && node.extras.title) || `Floor ${number}`;
    const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    const floor = { title, number, elevation, low, high, batches: [], labels: [] };
    for (const groupIndex of node.children || []) {
      const groupNode = gltf.nodes[groupIndex];
      const group = groupNode.name.split("/").pop();
      const batches = new Map();
      for (const child of groupNode.children || []) {
        const item = gltf.nodes[child];
        const matrix = compose(item);
        if (!batches.has(item.mesh)) batches.set(item.mesh, { matrices: [], ids: [] });
        batches.get(item.mesh).matrices.push(matrix);
        batches.get(item.mesh).ids.push(items.length + 1);
        const box = bounds(gltf, item.mesh, matrix, elevation);
        const { room, label, label_at: at } = item.extras || {};
        items.push({ id: item.name, room, label, group, floor, size: extent(gltf, item), ...box });
        for (let i = 0; i < 3; i++) {
          floor.low[i] = Math.min(floor.low[i], box.low[i]);
          floor.high[i] = Math.max(floor.high[i], box.high[i]);
        }
        if (label) floor.labels.push({ lines: label, at, ...box });
      }
      for (const [mesh, { matrices, ids }] of batches) {
        for (const primitive of gltf.meshes[mesh].primitives) floor.batches.push({ primitive, group, matrices, ids });
      }
    }
    floors.push(floor);
  }
  const rooms = new Map(items.filter((item) => item.label).map((item) => [item.id, item.label]));
  return { gltf, read, picture, floors, items, rooms, turns: (root.extras || {}).turns || 0 };
}

// Lowest and highest corner of a placed mesh, in the building's frame.
function bounds(gltf, mesh, matrix, elevation) {
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  for (const primitive of gltf.meshes[mesh].primitives) {
    const { min, max } = gltf.accessors[primitive.attributes.POSITION];
    for (let corner = 0; corner < 8; corner++) {
      const p = transform(matrix, [0, 1, 2].map((i) => ((corner >> i) & 1 ? max : min)[i]));
      p[1] += elevation;
      for (let i = 0; i < 3; i++) {
        low[i] = Math.min(low[i], p[i]);
        high[i] = Math.max(high[i], p[i]);
      }
    }
  }
  return { low, high };
}

// Width, depth and height of an element before it is turned, metres.
function extent(gltf, node) {
  const corners = gltf.meshes[node.mesh].primitives.map((primitive) => gltf.accessors[primitive.attributes.POSITION]);
  const scale = node.scale || [1, 1, 1];
  const [w, h, d] = [0, 1, 2].map((i) => scale[i] * (Math.max(...corners.map((c) => c.max[i])) - Math.min(...corners.map((c) => c.min[i]))));
  return [w, d, h];
}

const words = (text) => {
  const plain = text.replace(/_/g, " ");
  return plain.charAt(0).toUpperCase() + plain.slice(1);
};

// What a person calls an element and where it is.
function describe(building, item) {
  const parts = item.id.split("/");
  const own = parts.length > 2 && item.group === "doors" ? parts.slice(1).join(" ") : parts[parts.length - 1];
  const room = building.rooms.get(item.room || "");
  const [name, area] = item.label || [words(own), ""];
  const where = [room && !item.label ? room[0] : "", building.floors.length > 1 ? item.floor.title : ""].filter(Boolean).join(", ");
  const size = item.group === "objects" ? `${item.size.map((value) => value.toFixed(2)).join(" × ")} m (w × d × h)` : area || "";
  return { id: item.id, name, where, size };
}
