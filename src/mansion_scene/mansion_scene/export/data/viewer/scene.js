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
    const size = { SCALAR: 1, VEC3: 3 }[accessor.type];
    const Type = { 5126: Float32Array, 5123: Uint16Array, 5125: Uint32Array }[accessor.componentType];
    return new Type(buffer, start + (bytes.byteOffset || 0), accessor.count * size);
  };
  return { gltf, read };
}

// floors: [{name, number, elevation, batches: [{mesh, primitive, group, matrices, ids}], labels: [...]}]
function readBuilding(buffer) {
  const { gltf, read } = parseGlb(buffer);
  const names = [];
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const floors = [];
  for (const index of gltf.nodes[gltf.scenes[0].nodes[0]].children || []) {
    const node = gltf.nodes[index];
    const elevation = (node.translation || [0, 0, 0])[1];
    const number = parseInt(node.name.split("_").pop(), 10);
    const title = (node.extras && node.extras.title) || `Floor ${number}`;
    const floor = { name: node.name, title, number, elevation, batches: [], labels: [] };
    for (const groupIndex of node.children || []) {
      const groupNode = gltf.nodes[groupIndex];
      const batches = new Map();
      for (const child of groupNode.children || []) {
        const item = gltf.nodes[child];
        const matrix = compose(item);
        if (!batches.has(item.mesh)) batches.set(item.mesh, { matrices: [], ids: [] });
        batches.get(item.mesh).matrices.push(matrix);
        batches.get(item.mesh).ids.push(names.length + 1);
        names.push(item.name);
        grow(gltf, item.mesh, matrix, elevation, low, high);
        if (item.extras && item.extras.label) floor.labels.push({ lines: item.extras.label, at: item.extras.label_at });
      }
      const group = groupNode.name.split("/").pop();
      for (const [mesh, { matrices, ids }] of batches) {
        for (const primitive of gltf.meshes[mesh].primitives) floor.batches.push({ primitive, group, matrices, ids });
      }
    }
    floors.push(floor);
  }
  return { gltf, read, floors, names, low, high, title: gltf.nodes[gltf.scenes[0].nodes[0]].name };
}

function grow(gltf, mesh, matrix, elevation, low, high) {
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
}
