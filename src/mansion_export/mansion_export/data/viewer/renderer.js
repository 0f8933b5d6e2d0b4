// Draws the building with WebGL 2: one instanced call for each primitive of a floor.

const VERTEX = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in mat4 place;
layout(location = 6) in float id;
layout(location = 7) in vec2 coordinates;
uniform mat4 camera;
uniform float lift;
out vec3 side;
out float height;
out vec3 spot;
out vec2 tile;
flat out float number;
void main() {
  vec4 world = place * vec4(position, 1.0);
  spot = world.xyz;
  tile = coordinates;
  height = world.y;
  side = mat3(place) * (normal / vec3(dot(place[0].xyz, place[0].xyz), dot(place[1].xyz, place[1].xyz), dot(place[2].xyz, place[2].xyz)));
  number = id;
  gl_Position = camera * (world + vec4(0.0, lift, 0.0, 0.0));
}`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec3 side;
in float height;
in vec3 spot;
in vec2 tile;
flat in float number;
uniform vec4 color;
uniform sampler2D picture;
uniform sampler2D relief;
uniform vec2 textured;
uniform vec3 emission;
uniform float cut;
uniform float picking;
uniform float chosen;
uniform vec3 eye;
out vec4 shown;
// The normal that the relief gives a face, with the axes of its tile from the derivatives of place and coordinates.
vec3 bumped(vec3 n) {
  vec3 px = dFdx(spot), py = dFdy(spot);
  vec2 tx = dFdx(tile), ty = dFdy(tile);
  vec3 a = cross(py, n), b = cross(n, px);
  vec3 across = a * tx.x + b * ty.x, down = a * tx.y + b * ty.y;
  float size = inversesqrt(max(max(dot(across, across), dot(down, down)), 1e-20));
  vec3 m = texture(relief, tile).xyz * 2.0 - 1.0;
  return normalize(across * size * m.x - down * size * m.y + n * m.z);
}
void main() {
  vec3 smoothed = normalize(gl_FrontFacing ? side : -side);
  vec3 n = textured.y > 0.5 ? bumped(smoothed) : smoothed;
  vec3 base = textured.x > 0.5 ? color.rgb * texture(picture, tile).rgb : color.rgb;
  if (height > cut) discard;
  if (picking > 0.5) {
    shown = vec4(mod(number, 256.0), mod(floor(number / 256.0), 256.0), floor(number / 65536.0), 255.0) / 255.0;
    return;
  }
  float sun = max(dot(n, normalize(vec3(-0.45, 0.95, 0.62))), 0.0);
  float sky = 0.5 + 0.5 * n.y;
  float front = max(dot(n, eye), 0.0);
  vec3 light = vec3(0.44, 0.46, 0.5) + 0.16 * sky + 0.30 * sun * vec3(1.0, 0.97, 0.92) + 0.16 * front;
  vec3 lit = base * light + (textured.x > 0.5 ? emission * base : emission);
  if (!gl_FrontFacing && cut < 4.9) lit *= 0.45;
  if (abs(number - chosen) < 0.5) lit = mix(lit, vec3(1.0, 0.55, 0.1), 0.6);
  shown = vec4(pow(lit, vec3(1.0 / 2.2)), color.a);
}`;

class Renderer {
  constructor(canvas, building) {
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("this browser has no WebGL 2");
    this.gl = gl;
    this.canvas = canvas;
    this.program = this.link();
    this.uniforms = {};
    for (const name of ["camera", "lift", "color", "emission", "cut", "picking", "chosen", "eye", "textured", "picture", "relief"]) {
      this.uniforms[name] = gl.getUniformLocation(this.program, name);
    }
    this.pictures = new Map();
    this.buffers = new Map();
    for (const floor of building.floors) floor.draws = floor.batches.map((batch) => this.upload(building, batch));
    this.ids = null;
    this.stale = true;
  }

  link() {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  buffer(building, accessor, target) {
    if (!this.buffers.has(accessor)) {
      const handle = this.gl.createBuffer();
      this.gl.bindBuffer(target, handle);
      this.gl.bufferData(target, building.read(accessor), this.gl.STATIC_DRAW);
      this.buffers.set(accessor, handle);
    }
    return this.buffers.get(accessor);
  }

  upload(building, batch) {
    const gl = this.gl;
    const { attributes, indices, material } = batch.primitive;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    [attributes.POSITION, attributes.NORMAL].forEach((accessor, slot) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer(building, accessor, gl.ARRAY_BUFFER));
      gl.enableVertexAttribArray(slot);
      gl.vertexAttribPointer(slot, 3, gl.FLOAT, false, 0, 0);
    });
    const count = batch.matrices.length;
    const instances = new Float32Array(count * 17);
    batch.matrices.forEach((matrix, i) => {
      instances.set(matrix, i * 17);
      instances[i * 17 + 16] = batch.ids[i];
    });
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, instances, gl.STATIC_DRAW);
    for (let slot = 0; slot < 5; slot++) {
      gl.enableVertexAttribArray(2 + slot);
      gl.vertexAttribPointer(2 + slot, slot < 4 ? 4 : 1, gl.FLOAT, false, 68, slot * 16);
      gl.vertexAttribDivisor(2 + slot, 1);
    }
    if (attributes.TEXCOORD_0 !== undefined) {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer(building, attributes.TEXCOORD_0, gl.ARRAY_BUFFER));
      gl.enableVertexAttribArray(7);
      gl.vertexAttribPointer(7, 2, gl.FLOAT, false, 0, 0);
    }
    gl.bindVertexArray(null);
    const elements = this.buffer(building, indices, gl.ELEMENT_ARRAY_BUFFER);
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, elements);
    gl.bindVertexArray(null);
    const accessor = building.gltf.accessors[indices];
    const look = building.gltf.materials[material];
    return {
      array, count, group: batch.group, length: accessor.count, type: accessor.componentType,
      color: look.pbrMetallicRoughness.baseColorFactor, emission: look.emissiveFactor || [0, 0, 0],
      picture: look.pbrMetallicRoughness.baseColorTexture, relief: look.normalTexture,
    };
  }

  // Decodes the pictures that are shown; until they are there, materials are plain.
  async loadPictures(building) {
    const gl = this.gl;
    const wanted = new Map();
    for (const floor of building.floors) {
      for (const { picture, relief } of floor.draws) {
        if (picture) wanted.set(picture.index, gl.SRGB8_ALPHA8);
        if (relief) wanted.set(relief.index, gl.RGBA8);
      }
    }
    const sharpen = gl.getExtension("EXT_texture_filter_anisotropic");
    await Promise.all([...wanted].map(async ([index, format]) => {
      const image = await createImageBitmap(building.picture(index), { colorSpaceConversion: "none" });
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, format, gl.RGBA, gl.UNSIGNED_BYTE, image);
      gl.generateMipmap(gl.TEXTURE_2D);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
      if (sharpen) gl.texParameterf(gl.TEXTURE_2D, sharpen.TEXTURE_MAX_ANISOTROPY_EXT, 8);
      this.pictures.set(index, texture);
    }));
  }

  // Binds a draw's pictures, as far as they are decoded.
  dress(draw) {
    const gl = this.gl;
    const found = [draw.picture, draw.relief].map((entry) => (entry ? this.pictures.get(entry.index) : undefined));
    found.forEach((texture, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture || null);
    });
    gl.uniform2f(this.uniforms.textured, found[0] ? 1 : 0, found[1] ? 1 : 0);
  }

  draw(floors, options, picking = false) {
    const gl = this.gl;
    if (!picking) this.stale = true;
    gl.useProgram(this.program);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(...(picking ? [0, 0, 0, 0] : [0.965, 0.968, 0.974, 1]));
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.uniformMatrix4fv(this.uniforms.camera, false, options.camera);
    gl.uniform3fv(this.uniforms.eye, options.eye);
    gl.uniform1f(this.uniforms.picking, picking ? 1 : 0);
    gl.uniform1f(this.uniforms.chosen, options.chosen);
    gl.uniform1i(this.uniforms.picture, 0);
    gl.uniform1i(this.uniforms.relief, 1);
    for (const glass of [false, true]) {
      if (glass && picking) break;
      gl.depthMask(!glass);
      if (glass) {
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
      } else {
        gl.disable(gl.BLEND);
      }
      for (const floor of floors) {
        gl.uniform1f(this.uniforms.lift, floor.lift);
        for (const draw of floor.draws) {
          if (draw.color[3] < 1 !== glass || options.hidden.has(draw.group)) continue;
          gl.uniform1f(this.uniforms.cut, draw.group === "objects" ? 1e9 : options.cut);
          gl.uniform4fv(this.uniforms.color, draw.color);
          gl.uniform3fv(this.uniforms.emission, draw.emission);
          this.dress(draw);
          gl.bindVertexArray(draw.array);
          gl.drawElementsInstanced(gl.TRIANGLES, draw.length, draw.type, 0, draw.count);
        }
      }
    }
    gl.depthMask(true);
    gl.bindVertexArray(null);
  }

  // The id below a pixel. The picture of ids is kept until something else is drawn.
  pick(floors, options, x, y) {
    const gl = this.gl;
    const [width, height] = [this.canvas.width, this.canvas.height];
    if (!this.ids || this.ids.width !== width || this.ids.height !== height) this.prepare(width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.ids.frame);
    if (this.stale) this.draw(floors, options, true);
    this.stale = false;
    const pixel = new Uint8Array(4);
    gl.readPixels(x, height - 1 - y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return pixel[0] + 256 * pixel[1] + 65536 * pixel[2];
  }

  prepare(width, height) {
    const gl = this.gl;
    if (this.ids) {
      gl.deleteFramebuffer(this.ids.frame);
      this.ids.buffers.forEach((buffer) => gl.deleteRenderbuffer(buffer));
    }
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    const buffers = [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]].map(([format, place]) => {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
      return buffer;
    });
    this.ids = { frame, buffers, width, height };
    this.stale = true;
  }
}
