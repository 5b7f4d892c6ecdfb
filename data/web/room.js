// A scene with its probes in WebGL2: `boxprobeRoom(host, json, options)` draws what `boxprobe render` draws, put together
// from the program's own shader files, which the JSON holds (app/web/web_scene.h). Orbit by dragging or arrow keys; technique,
// roughness, box and capture origin by sliders. Without WebGL2 it says so, and what stood in the host stays.
'use strict';
(() => {
  // A viewer has this file alone, in English.
  const say = typeof boxprobeDrawing === 'undefined' ? (text, ...values) => text.replace(/\{(\d)\}/g, (_, i) => values[i]) : boxprobeDrawing.say;
  const sub = (a, b) => a.map((v, i) => v - b[i]), add = (a, b) => a.map((v, i) => v + b[i]), scaled = (a, s) => a.map((v) => v * s);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2], length = (a) => Math.sqrt(dot(a, a)), unit = (a) => scaled(a, 1 / length(a));
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
  const copy = (value) => JSON.parse(JSON.stringify(value));

  function viewAxes(camera) {
    const back = unit(sub(camera.position, camera.target)), right = unit(cross(camera.up, back));
    return { right, up: cross(back, right), back };
  }

  /** Column by column, clip space from the world; `tangents`: of half the field of view. */
  function clipFromWorld(eye, { right, up, back }, tangents, near, far) {
    const rows = [right, up, back].map((axis) => [...axis, -dot(axis, eye)]);
    const depth = rows[2].map((v) => v * (far + near) / (near - far));
    depth[3] += 2 * far * near / (near - far);
    const clip = [rows[0].map((v) => v / tangents[0]), rows[1].map((v) => v / tangents[1]), depth, rows[2].map((v) => -v)];
    return [0, 1, 2, 3].flatMap((column) => clip.map((row) => row[column]));
  }

  const CRC = Uint32Array.from({ length: 256 }, (_, n) => {
    for (let bit = 0; bit < 8; bit++) n = n & 1 ? 0xedb88320 ^ n >>> 1 : n >>> 1;
    return n;
  });
  /** CRC-32 of bytes, as PNG and ZIP have it. */
  function crc32(bytes) {
    let sum = -1;
    for (let i = 0; i < bytes.length; i++) sum = CRC[(sum ^ bytes[i]) & 255] ^ sum >>> 8;
    return ~sum >>> 0;
  }

  /** Levels of an uncompressed cube of half floats: [level][face] as Uint16Array, largest first (KTX 2.0). */
  function ktx2Levels(buffer) {
    const view = new DataView(buffer), levels = [];
    for (let level = 0; level < view.getUint32(40, true); level++) {
      const at = Number(view.getBigUint64(80 + 24 * level, true)), bytes = Number(view.getBigUint64(88 + 24 * level, true)) / 6;
      levels.push([0, 1, 2, 3, 4, 5].map((face) => new Uint16Array(buffer, at + face * bytes, bytes / 2)));
    }
    return { size: view.getUint32(20, true), levels };
  }

  const pictureOf = (bytes) => createImageBitmap(new Blob([bytes], { type: 'image/png' }), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });

  class Room {
    constructor(gl, scene, files) {
      this.gl = gl;
      this.scene = scene;
      this.files = files;
      this.programs = new Map();
      this.probes = copy(scene.probes);
      this.camera = copy(scene.cameras[0]);
      this.roughness = null;  // of what mirrors; null: each material's own
      const first = scene.probes[0] ? scene.probes[0].technique.split('+') : ['box', 'none'];
      this.row = this.findRow(...first) || this.findRow('box', 'footprint4');
      this.loaded = this.given = false;  // given: the context was given back
      this.losses = 0;  // of the context
      this.drawn = () => {};  // called after each picture
      this.custom = null;  // texts that take the place of shader files, by name; null: none
      this.extensions();
      const info = gl.getExtension('WEBGL_debug_renderer_info');
      this.renderer = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
    }

    extensions() {
      this.floatTargets = Boolean(this.gl.getExtension('EXT_color_buffer_float'));
      this.gl.getExtension('OES_texture_float_linear');
    }

    /** All of it, in a context that is new, or was lost and has come back: what it held is gone. */
    async restore() {
      this.programs.clear();
      this.framebuffer = this.space = undefined;
      this.extensions();
      await this.load();
      for (const probe of this.probes) {
        delete probe.captured;
        if (probe.recaptured) this.capture(probe);
      }
    }

    /** Whether it can be drawn: its context is there, and holds all of it. */
    get ready() { return this.loaded && !this.gl.isContextLost(); }

    /** Throws what WebGL holds against what was drawn: something is missing in the picture then. */
    check() {
      const error = this.gl.getError();
      if (error && !this.gl.isContextLost()) throw new Error(`WebGL error ${error}`);
    }

    findRow(projection, evaluation) {
      return this.scene.shaders.techniques.find((row) => row.projection[0] === projection && row.evaluation[0] === evaluation);
    }

    async load() {
      const { gl, scene, losses } = this;
      // Into a context that was lost meanwhile, and has come back, half of it would be left.
      const whole = (what) => {
        if (losses !== this.losses || gl.isContextLost()) throw new Error('the graphics card was taken away');
        return what;
      };
      const bytes = async (name) => {
        const answer = await fetch(this.files(name));
        if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
        const read = await answer.arrayBuffer();
        // Within one text nothing is cut off or exchanged alone.
        if (!scene.files && crc32(new Uint8Array(read)) !== scene.sums[name]) throw new Error(`${name} is cut off, damaged or of another export`);
        return whole(read);
      };
      this.vertices = gl.createVertexArray();
      gl.bindVertexArray(this.vertices);
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, await bytes('vertices.bin'), gl.STATIC_DRAW);
      for (const [place, count, offset] of [[0, 3, 0], [1, 3, 12], [2, 2, 24]]) {
        gl.enableVertexAttribArray(place);
        gl.vertexAttribPointer(place, count, gl.FLOAT, false, 32, offset);
      }
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, await bytes('indices.bin'), gl.STATIC_DRAW);
      gl.bindVertexArray(null);

      const table = new Uint16Array(await bytes(scene.splitSum.file));
      this.splitSum = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, this.splitSum);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG16F, scene.splitSum.size, scene.splitSum.size, 0, gl.RG, gl.FLOAT, Float32Array.from(table, (v) => v / 65535));
      for (const [key, value] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) gl.texParameteri(gl.TEXTURE_2D, key, value);

      this.black = this.cube({ size: 1, levels: [Array(6).fill(new Uint16Array(4))] });
      this.sky = scene.sky.file ? this.cube(ktx2Levels(await bytes(scene.sky.file))) : this.black;
      for (const probe of this.probes) probe.map = probe.baked = this.cube(ktx2Levels(await bytes(probe.file)));
      const pictures = new Map();
      for (const material of scene.materials) {
        for (const [key, srgb] of [['baseColorTexture', true], ['metallicRoughnessTexture', false], ['emissiveTexture', true]]) {
          const use = material[key];
          if (!use) continue;
          const id = use.file + srgb + use.wrap + use.nearest;
          if (!pictures.has(id)) pictures.set(id, this.picture(whole(await pictureOf(await bytes(use.file))), use, srgb));
          use.texture = pictures.get(id);
        }
      }
    }

    picture(image, use, srgb) {
      const { gl } = this;
      const texture = gl.createTexture(), wraps = [gl.REPEAT, gl.CLAMP_TO_EDGE, gl.MIRRORED_REPEAT];
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, srgb ? gl.SRGB8_ALPHA8 : gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, image);
      gl.generateMipmap(gl.TEXTURE_2D);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, use.nearest ? gl.NEAREST_MIPMAP_LINEAR : gl.LINEAR_MIPMAP_LINEAR);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, use.nearest ? gl.NEAREST : gl.LINEAR);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wraps[use.wrap[0]]);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wraps[use.wrap[1]]);
      const finer = gl.getExtension('EXT_texture_filter_anisotropic');
      if (finer && !use.nearest && !/llvmpipe|swiftshader/i.test(this.renderer)) gl.texParameterf(gl.TEXTURE_2D, finer.TEXTURE_MAX_ANISOTROPY_EXT, 8);
      return texture;
    }

    cube({ size, levels }) {
      const { gl } = this, texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
      levels.forEach((faces, level) => faces.forEach((data, face) =>
        gl.texImage2D(gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, level, gl.RGBA16F, Math.max(size >> level, 1), Math.max(size >> level, 1), 0, gl.RGBA, gl.HALF_FLOAT, data)));
      gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAX_LEVEL, levels.length - 1);
      gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
      gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
      return texture;
    }

    /** A program by its texts, compiled once. */
    program(key, vertex, fragment) {
      const { gl } = this;
      if (this.programs.has(key)) return this.programs.get(key);
      const head = '#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp samplerCube;\n';
      const program = gl.createProgram();
      for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, head + text);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
        gl.deleteShader(shader);  // with its program
      }
      ['bpVertexPosition', 'bpVertexNormal', 'bpVertexUv'].forEach((name, place) => gl.bindAttribLocation(program, place, name));
      gl.linkProgram(program);
      if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
        const error = new Error(gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader)).join('') + gl.getProgramInfoLog(program));
        error.source = head + fragment;
        gl.deleteProgram(program);
        throw error;
      }
      const made = { program, places: new Map() };
      made.at = (name) => {
        if (!made.places.has(name)) made.places.set(name, gl.getUniformLocation(program, name));
        return made.places.get(name);
      };
      this.programs.set(key, made);
      return made;
    }

    surfaceProgram(object, material, probes) {
      const { scene, row } = this, { texts } = scene.shaders;
      const defines = ['PROBE_MAP samplerCube', `BP_SLOTS ${probes.length}`, `BP_LIGHTS ${scene.lights.length}`, `BP_SKY ${scene.sky.file ? 1 : 0}`,
        `BP_BRDF_SIZE ${scene.splitSum.size}.0f`];
      if (scene.shaders.bevelled) defines.push('BP_BEVEL');
      if (scene.multiple) defines.push('BP_MULTIPLE');
      if (object.onlyProbes) defines.push('BP_ONLY_PROBES');
      if (material.unlit) defines.push('BP_UNLIT');
      if (material.baseColorTexture) defines.push('BP_BASE_MAP');
      if (material.metallicRoughnessTexture) defines.push('BP_ROUGHNESS_MAP');
      if (material.emissiveTexture) defines.push('BP_EMISSIVE_MAP');
      let groups = '';
      if (probes.length) {
        const by = [...new Set(probes.map((probe) => probe.importance))];
        defines.push(`BP_GROUPS ${by.length}`);
        groups = `const int bpGroupOf[${probes.length}] = int[${probes.length}](${probes.map((probe) => by.indexOf(probe.importance)).join(', ')});\n`;
      }
      const own = row.pieces.map((name) => this.custom?.[name]).join('');
      const key = `${row.projection[0]}+${row.evaluation[0]} ${defines.join(' ')} ${groups}${own}`;
      const pieces = [...row.pieces, ...scene.shaders.surface].map((name) => this.custom?.[name] ?? texts[name]);
      return this.program(key, texts['web/surface_vertex.glsl'], defines.map((line) => `#define ${line}\n`).join('') + pieces.slice(0, row.pieces.length).join('\n') + groups + pieces.slice(row.pieces.length).join('\n'));
    }

    /** Compiles what the camera sees with `custom`. Throws as `program` does: the error has its `source`. */
    tryCustom() {
      for (const object of this.scene.objects) {
        const material = this.scene.materials[object.material];
        if (object.visible && !material.unlit && object.probes.length) this.surfaceProgram(object, material, object.probes.map((i) => this.probes[i]));
      }
    }

    /** Frees the programs of texts that are no longer used. */
    forgetCustom(custom) {
      for (const text of Object.values(custom || {})) {
        for (const [key, { program }] of this.programs) {
          if (!key.endsWith(text) || Object.values(this.custom || {}).includes(text)) continue;
          this.gl.deleteProgram(program);
          this.programs.delete(key);
        }
      }
    }

    texture(program, name, unitNumber, target, texture) {
      const { gl } = this;
      gl.activeTexture(gl.TEXTURE0 + unitNumber);
      gl.bindTexture(target, texture);
      gl.uniform1i(program.at(name), unitNumber);
    }

    setProbe(program, slot, probe) {
      const { gl } = this, at = (field) => program.at(`bpProbe[${slot}].${field}`);
      gl.uniform3fv(at('origin'), probe.origin);
      probe.axes.forEach((axis, i) => gl.uniform3fv(at('axis' + 'XYZ'[i]), axis));
      gl.uniform3fv(at('bevelAndIntensity'), probe.bevelAndIntensity);
      gl.uniform3fv(at('occlusion'), probe.occlusion);
      gl.uniform3fv(at('shape.boxMin'), probe.boxMin);
      gl.uniform3fv(at('shape.boxMax'), probe.boxMax);
      gl.uniform1f(at('shape.maxLevel'), probe.maxLevel);
      for (const [name, value] of Object.entries(probe.parameters)) {
        if ('choice' in value) gl.uniform1i(at('shape.parameters.' + name), value.choice);
        else gl.uniform1f(at('shape.parameters.' + name), value.number);
      }
      for (const [name, key] of [['bpInfluenceMin', 'influenceMin'], ['bpInfluenceMax', 'influenceMax'], ['bpRateMin', 'rateMin'], ['bpRateMax', 'rateMax']]) {
        gl.uniform3fv(program.at(`${name}[${slot}]`), probe[key]);
      }
      gl.uniform1f(program.at(`bpOpen[${slot}]`), probe.open ? 1 : 0);
      for (let i = 0; i < 9; i++) gl.uniform3fv(program.at(`bpSh[${9 * slot + i}]`), probe.sh.slice(3 * i, 3 * i + 3));
      this.texture(program, 'bpMap' + slot, 4 + slot, gl.TEXTURE_CUBE_MAP, probe.map);
    }

    /** One view of everything into the framebuffer that is bound. `probes`: false in captures. */
    drawView({ eye, axes, tangents, near, far, width, height, exposure, capture, probes, clear = null }) {
      const { gl, scene } = this;
      gl.viewport(0, 0, width, height);
      gl.disable(gl.BLEND);
      gl.enable(gl.DEPTH_TEST);
      gl.clearColor(...(clear || [0, 0, 0]), 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      if (!clear) this.drawSky(axes, tangents, exposure);
      const matrix = clipFromWorld(eye, axes, tangents, near, far);
      gl.bindVertexArray(this.vertices);
      for (const object of scene.objects) {
        if (!(capture ? object.seenByProbes : object.visible)) continue;
        const material = scene.materials[object.material];
        const used = probes && !material.unlit ? object.probes.map((i) => this.probes[i]) : [];
        const program = this.surfaceProgram(object, material, used);
        gl.useProgram(program.program);
        gl.uniformMatrix4fv(program.at('bpClipFromWorld'), false, matrix);
        gl.uniform3fv(program.at('bpEye'), eye);
        gl.uniform1f(program.at('bpExposure'), exposure);
        gl.uniform4fv(program.at('bpBaseColor'), material.baseColor);
        gl.uniform3fv(program.at('bpEmissive'), material.emissive);
        gl.uniform3f(program.at('bpMetalRoughF0'), material.metallic, this.roughness !== null && this.mirrors(material) ? this.roughness : material.roughness, material.f0);
        gl.uniform1f(program.at('bpAlphaCutoff'), material.alphaCutoff);
        if (!material.unlit) this.texture(program, 'bpSplitSumMap', 3, gl.TEXTURE_2D, this.splitSum);
        [['bpBaseMap', 'bpBaseFromUv', material.baseColorTexture], ['bpRoughnessMap', 'bpRoughnessFromUv', material.metallicRoughnessTexture],
          ['bpEmissiveMap', 'bpEmissiveFromUv', material.emissiveTexture]].forEach(([name, transform, use], i) => {
          if (!use || !program.at(name)) return;
          this.texture(program, name, i, gl.TEXTURE_2D, use.texture);
          gl.uniformMatrix3fv(program.at(transform), false, use.transform);
        });
        if (scene.sky.file && !material.unlit) {
          this.texture(program, 'bpSkyMap', 8, gl.TEXTURE_CUBE_MAP, this.sky);
          gl.uniform1f(program.at('bpSkyMaxLevel'), scene.sky.maxLevel);
          for (let i = 0; i < 9; i++) gl.uniform3fv(program.at(`bpSkySh[${i}]`), scene.sky.sh.slice(3 * i, 3 * i + 3));
        }
        scene.lights.forEach((light, i) => {
          gl.uniform4f(program.at(`bpLightDirection[${i}]`), ...light.direction, light.type);
          gl.uniform4f(program.at(`bpLightPosition[${i}]`), ...light.position, light.perRange);
          gl.uniform3fv(program.at(`bpLightRadiance[${i}]`), light.radiance);
          gl.uniform2fv(program.at(`bpLightCosines[${i}]`), light.cosines);
        });
        used.forEach((probe, slot) => this.setProbe(program, slot, probe));
        if (material.doubleSided) gl.disable(gl.CULL_FACE);
        else gl.enable(gl.CULL_FACE);
        gl.drawElements(gl.TRIANGLES, object.count, gl.UNSIGNED_INT, 4 * object.first);
      }
      gl.bindVertexArray(null);
    }

    drawSky({ right, up, back }, tangents, exposure) {
      const { gl, scene } = this, { texts } = scene.shaders;
      const corner = 'out vec2 texCoord;\nvoid main()\n{\n  texCoord = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);\n  gl_Position = vec4(2.0 * texCoord - 1.0, 0.0, 1.0);\n}\n';
      const program = this.program('sky', corner, texts['shared/sky.glsl'] + texts['shared/display.glsl'] + texts['web/sky.glsl']);
      gl.useProgram(program.program);
      gl.disable(gl.CULL_FACE);
      gl.depthMask(false);
      for (const [name, key] of [['bpSkyTop', 'top'], ['bpSkyHorizon', 'horizon'], ['bpSkyGround', 'ground']]) gl.uniform3fv(program.at(name), scene.sky[key]);
      gl.uniform1f(program.at('bpSkyPicture'), scene.sky.picture ? 1 : 0);
      gl.uniform1f(program.at('bpExposure'), exposure);
      gl.uniformMatrix3fv(program.at('bpWorldFromView'), false, [...right, ...up, ...back]);
      gl.uniform2fv(program.at('bpTangents'), tangents);
      this.texture(program, 'bpSkyMap', 8, gl.TEXTURE_CUBE_MAP, this.sky);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      gl.depthMask(true);
    }

    target(size, level, texture, face) {
      const { gl } = this;
      this.framebuffer = this.framebuffer || gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
      const where = face === undefined ? gl.TEXTURE_2D : gl.TEXTURE_CUBE_MAP_POSITIVE_X + face;
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, where, texture, level);
      gl.viewport(0, 0, size, size);
    }

    emptyCube(size, levels) {
      const { gl } = this, texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
      gl.texStorage2D(gl.TEXTURE_CUBE_MAP, levels, gl.RGBA16F, size, size);
      gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
      gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
      return texture;
    }

    fullScreen(name, text) {
      const { texts } = this.scene.shaders;
      return this.program(name, texts['gpu/full_screen_vertex.glsl'], 'in vec2 texCoord;\nout vec4 bpColor;\n' + text.replaceAll('gl_FragData[0]', 'bpColor'));
    }

    /** The probe's cubemap again from `origin`, in the world: faces drawn without reflections (the first bounce), levels filtered by
     * the program's own prefilter. What bakes after more bounces see, and irradiance, stay as they were exported. */
    recapture(probe, origin) {
      const moved = probe.axes.map((axis) => dot(axis, sub(origin, probe.origin)));
      for (const key of ['boxMin', 'boxMax', 'influenceMin', 'influenceMax']) probe[key] = sub(probe[key], moved);
      probe.origin = origin;
      probe.recaptured = true;
      if (this.ready) this.capture(probe);  // otherwise as soon as it is
    }

    capture(probe) {
      const { gl, scene } = this, { texts } = scene.shaders, size = probe.faceSize, samples = 2 * size, { origin } = probe;
      const space = this.space = this.space && this.space.size === size ? this.space : this.captureSpace(size, samples);
      const faces = [[[1, 0, 0], [0, 0, -1], [0, -1, 0]], [[-1, 0, 0], [0, 0, 1], [0, -1, 0]], [[0, 1, 0], [1, 0, 0], [0, 0, 1]],
        [[0, -1, 0], [1, 0, 0], [0, 0, -1]], [[0, 0, 1], [1, 0, 0], [0, -1, 0]], [[0, 0, -1], [-1, 0, 0], [0, -1, 0]]];
      const world = (v) => [0, 1, 2].map((i) => v[0] * probe.axes[0][i] + v[1] * probe.axes[1][i] + v[2] * probe.axes[2][i]);
      const half = this.fullScreen('half', 'uniform sampler2D bpPicture;\nvoid main() { bpColor = texture(bpPicture, texCoord); }\n');
      const lobe = ['shared/cube.glsl', 'shared/lobe_frame.glsl', 'shared/edge_fixup.glsl', 'gpu/nearest_half.glsl', 'gpu/prefilter_lobe.glsl'].map((name) => texts[name]).join('\n');
      const source = ['shared/cube.glsl', 'shared/source_level.glsl', 'gpu/nearest_half.glsl', 'gpu/prefilter_source.glsl'].map((name) => texts[name]).join('\n');
      faces.forEach(([forward, right, up], face) => {
        gl.bindFramebuffer(gl.FRAMEBUFFER, space.framebuffer);
        this.drawView({ eye: origin, axes: { right: world(right), up: world(up), back: scaled(world(forward), -1) }, tangents: [1, 1], near: probe.near, far: probe.far,
          width: samples, height: samples, exposure: -1, capture: true, probes: false, clear: probe.clear });
        this.target(size, 0, space.source, face);
        this.plain(half, () => this.texture(half, 'bpPicture', 0, gl.TEXTURE_2D, space.picture));
      });
      const levels = Math.log2(size) + 1, reduce = this.fullScreen('source', source);
      const only = (low, high) => {
        gl.bindTexture(gl.TEXTURE_CUBE_MAP, space.source);
        gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_BASE_LEVEL, low);
        gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAX_LEVEL, high);
      };
      for (let level = 1; level < levels; level++) {
        only(level - 1, level - 1);
        for (let face = 0; face < 6; face++) {
          this.target(size >> level, level, space.source, face);
          this.plain(reduce, () => {
            this.texture(reduce, 'bpSource', 0, gl.TEXTURE_CUBE_MAP, space.source);
            gl.uniform1i(reduce.at('bpFace'), face);
            gl.uniform1f(reduce.at('bpFaceSize'), size >> level);
            gl.uniform1f(reduce.at('bpLevel'), 0);
          });
        }
      }
      only(0, levels - 1);
      if (!probe.captured) probe.captured = this.emptyCube(size, probe.maxLevel + 1);
      probe.map = probe.captured;
      const taps = scene.prefilter[size], most = Math.max(...taps.map((list) => list.length / 4));
      const filter = this.fullScreen('lobe' + most, lobe.replace(/layout\(std140\) uniform bpTapBlock.*/, `uniform vec4 bpTaps[${most}];`));
      for (let level = 0; level <= probe.maxLevel; level++) {
        const list = level ? taps[level - 1] : [0, 0, 0, 1];  // level 0: the capture itself
        for (let face = 0; face < 6; face++) {
          this.target(size >> level, level, probe.map, face);
          this.plain(filter, () => {
            this.texture(filter, 'bpSource', 0, gl.TEXTURE_CUBE_MAP, space.source);
            gl.uniform1i(filter.at('bpFace'), face);
            gl.uniform1f(filter.at('bpFaceSize'), size >> level);
            gl.uniform1f(filter.at('bpFixupWidth'), 0);
            gl.uniform1i(filter.at('bpTapCount'), list.length / 4);
            gl.uniform4fv(filter.at('bpTaps[0]'), list);
          });
        }
      }
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }

    plain(program, set) {
      const { gl } = this;
      gl.useProgram(program.program);
      gl.disable(gl.DEPTH_TEST);
      gl.disable(gl.CULL_FACE);
      set();
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    captureSpace(size, samples) {
      const { gl } = this, space = { size, framebuffer: gl.createFramebuffer(), picture: gl.createTexture(), source: this.emptyCube(size, Math.log2(size) + 1) };
      gl.bindTexture(gl.TEXTURE_2D, space.picture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA16F, samples, samples);
      for (const key of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, key, gl.LINEAR);
      const depth = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
      gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, samples, samples);
      gl.bindFramebuffer(gl.FRAMEBUFFER, space.framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, space.picture, 0);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
      return space;
    }

    /** What the roughness slider is for: metal that reflects. */
    mirrors(material) { return !material.unlit && material.metallic >= 0.5 && Math.max(...material.baseColor.slice(0, 3)) > 0; }

    /** The camera's picture into the canvas's own framebuffer. */
    draw(width = this.gl.drawingBufferWidth, height = this.gl.drawingBufferHeight) {
      const { camera, scene } = this;
      const low = [0, 1, 2].map((i) => Math.min(...scene.objects.map((o) => o.min[i]))), high = [0, 1, 2].map((i) => Math.max(...scene.objects.map((o) => o.max[i])));
      const far = length(sub(camera.position, scaled(add(low, high), 0.5))) + 0.5 * length(sub(high, low)) + 1e-3;
      const tangent = Math.tan(camera.verticalFovDegrees * Math.PI / 360);
      this.drawView({ eye: camera.position, axes: viewAxes(camera), tangents: [tangent * width / height, tangent], near: Math.max(far * 1e-4, 0.01), far, width, height,
        exposure: scene.exposure, capture: false, probes: true });
      this.drawn();
    }
  }

  function element(name, attributes, parent, text) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    if (parent) parent.append(made);
    return made;
  }

  /** A room's hold on its WebGL context. A browser keeps some 16 contexts and takes the oldest away for another one: out of view the room
   * gives its own back, and it takes it again when it comes into view. Meanwhile its last picture stands in the place of the canvas. */
  class Hold {
    constructor(host, room) {
      Object.assign(this, { host, room, canvas: room.gl.canvas, near: true, busy: false });
      this.context = room.gl.getExtension('WEBGL_lose_context');  // null: the browser keeps that to itself, and the room its context
      this.still = element('canvas', { 'aria-hidden': 'true' });
      this.there = Promise.resolve();  // pending while the context is lost
      this.canvas.addEventListener('webglcontextlost', (event) => {
        event.preventDefault();  // it may come back
        this.lost();
      });
      this.canvas.addEventListener('webglcontextrestored', () => this.restored());
      room.drawn = () => {
        clearTimeout(this.later);
        this.later = setTimeout(() => this.keep(), 300);  // when nothing moves any more
      };
    }

    /** Comes into view, or leaves it. */
    look(near) {
      this.near = near;
      const { room } = this;
      if (!this.context || this.failed) return;
      if (near && room.gl.isContextLost()) {
        this.context.restoreContext();
      } else if (!near && room.ready && !this.busy) {
        this.keep();
        room.given = true;
        this.context.loseContext();
      }
    }

    keep() {
      const { still, canvas } = this;
      if (!this.room.ready) return;
      Object.assign(still, { width: canvas.width, height: canvas.height });
      still.getContext('2d').drawImage(canvas, 0, 0);
      this.kept = true;
    }

    lost() {
      const { room, host } = this;
      if (this.failed) return;
      room.losses++;
      room.loaded = false;
      if (!this.near) room.given = true;  // nobody sees it
      this.there = new Promise((resolve) => { this.back = resolve; });
      this.focused = document.activeElement === this.canvas;
      if (this.kept && this.canvas.isConnected) this.canvas.replaceWith(this.still);
      if (!room.given) this.line = this.line || element('p', { class: 'room-said', role: 'alert' }, host, say('The browser has taken the graphics card away from this room. If it does not come back, load the page again to draw it.'));
      else if (this.near) setTimeout(() => this.look(this.near));  // it has come into view again since
    }

    async restored() {
      const { room, host } = this;
      this.back();
      if (this.busy || this.failed) return;  // whoever loads begins again
      try {
        await this.bring();
      } catch (error) {
        this.fail(error);
        return;
      }
      this.still.replaceWith(this.canvas);
      if (this.focused && document.activeElement === document.body) this.canvas.focus({ preventScroll: true });
      this.unsay();
      const { given } = room;
      room.given = false;
      if (host.boxprobePanel) host.boxprobePanel.redraw();
      host.dispatchEvent(new CustomEvent('boxproberestored', { detail: { given } }));
      this.look(this.near);
    }

    /** Loads what the context holds and draws it; once more if the context is lost meanwhile. `prepare`: of the first picture. */
    async bring(prepare) {
      const { room } = this, { gl } = room;
      this.busy = true;
      try {
        for (let losses = -1; losses !== room.losses || gl.isContextLost();) {
          await this.there;
          losses = room.losses;
          for (let i = 0; i < 8 && gl.getError(); i++);  // those of what was lost
          try {
            await room.restore();
            if (prepare) prepare(room);
            prepare = null;  // once
            room.draw();
            room.check();
          } catch (error) {
            if (losses === room.losses && !gl.isContextLost()) throw error;
          }
        }
        room.loaded = true;
      } finally {
        this.busy = false;
      }
    }

    unsay() {
      if (this.line) this.line.remove();
      this.line = null;
    }

    /** The end: a line in the canvas's place, or below the last picture. */
    fail(error) {
      this.failed = true;
      this.room.loaded = false;
      this.canvas.remove();
      this.unsay();
      element('p', { class: 'room-said', role: 'alert' }, this.host, say('The scene cannot be drawn here ({0}): the pictures show what could be moved.', error.message));
    }
  }

  class Panel {
    constructor(host, room, options, failed) {
      this.room = room;
      this.host = host;
      this.failed = failed;
      this.options = options;
      this.canvas = room.gl.canvas;
      this.controls = element('div', { class: 'room-sliders' }, host);
      this.said = element('p', { class: 'room-said', 'aria-live': 'polite' }, host);
      this.build();
      this.orbit();
      new ResizeObserver(() => this.redraw()).observe(this.canvas);
      this.redraw();
    }

    redraw() {
      if (this.waiting) return;
      this.waiting = true;
      requestAnimationFrame(() => {
        this.waiting = false;
        if (!this.room.ready) return;
        const finer = Math.min(window.devicePixelRatio || 1, 2), shape = this.options.shape || 1.6;
        const width = Math.max(Math.round(this.canvas.clientWidth * finer), 1), height = Math.max(Math.round(width / shape), 1);
        if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
        try {
          this.room.draw();
        } catch (error) {
          this.failed(error);
          return;
        }
        this.host.dataset.drawn = String(Number(this.host.dataset.drawn || 0) + 1);
        this.host.dispatchEvent(new Event('boxprobechange'));
      });
    }

    choice(name, shown, options, chosen, changed) {
      const label = element('label', {}, this.controls);
      element('span', { class: 'name' }, label, shown);
      const select = element('select', { 'data-control': name }, label);
      for (const [id, text] of options) element('option', { value: id }, select, text);
      select.value = chosen;
      select.addEventListener('change', () => { changed(select.value); this.redraw(); });
      return select;
    }

    slider(name, shown, low, high, value, changed, done) {
      const label = element('label', {}, this.controls);
      element('span', { class: 'name' }, label, shown);
      const step = 10 ** Math.floor(Math.log10((high - low) / 100)), even = (v) => Math.round(v / step) * step;  // 0.01 for a room
      const input = element('input', { type: 'range', min: even(low), max: even(high), step, 'data-control': name }, label);
      const output = element('output', {}, label);
      input.value = value;
      const show = () => { output.textContent = Number(input.value).toFixed(2); };
      show();
      input.addEventListener('input', () => { show(); changed(Number(input.value)); this.redraw(); });
      if (done) input.addEventListener('change', () => done(Number(input.value)));
    }

    build() {
      const { room } = this, { scene } = room;
      this.controls.replaceChildren();
      const unique = (key) => [...new Map(scene.shaders.techniques.map((row) => row[key])).entries()];
      const choose = (projection, evaluation) => { room.row = room.findRow(projection, evaluation) || room.row; };
      this.choice('projection', say('projection'), unique('projection'), room.row.projection[0], (id) => choose(id, room.row.evaluation[0]));
      this.choice('evaluation', say('evaluation'), unique('evaluation'), room.row.evaluation[0], (id) => choose(room.row.projection[0], id));
      if (scene.cameras.length > 1) {
        this.choice('camera', say('camera'), scene.cameras.map((camera) => [camera.name, camera.name]), room.camera.name, (name) => {
          room.camera = copy(scene.cameras.find((camera) => camera.name === name));
        });
      }
      const mirror = scene.materials.find((material) => room.mirrors(material));
      if (mirror) this.slider('roughness', say('roughness'), 0, 1, room.roughness ?? mirror.roughness, (value) => { room.roughness = value; });
      if (!room.probes.length) return;
      this.probe = Math.min(this.probe || 0, room.probes.length - 1);
      if (room.probes.length > 1) {
        this.choice('probe', say('probe'), room.probes.map((probe, i) => [String(i), probe.name]), String(this.probe), (i) => { this.probe = Number(i); this.build(); });
      }
      const probe = room.probes[this.probe], given = scene.probes[this.probe];
      const world = (q, i) => dot(q.origin, q.axes[i]);
      for (let i = 0; i < 3; i++) {
        for (const side of ['boxMin', 'boxMax']) {
          const at = given[side][i] + world(given, i), reach = 0.5 * (given.boxMax[i] - given.boxMin[i]);
          const face = `${side === 'boxMin' ? '−' : '+'}${'xyz'[i]}`;
          this.slider(`box ${face}`, say('box {0}', face), at - (side === 'boxMin' ? reach : 0.9 * reach), at + (side === 'boxMin' ? 0.9 * reach : reach), probe[side][i] + world(probe, i), (value) => {
            probe[side][i] = value - world(probe, i);
          });
        }
      }
      if (room.floatTargets) {
        for (let i = 0; i < 3; i++) {
          const low = given.boxMin[i] + world(given, i), high = given.boxMax[i] + world(given, i), size = high - low;
          this.slider(`origin ${'xyz'[i]}`, say('origin {0}', 'xyz'[i]), low + 0.05 * size, high - 0.05 * size, world(probe, i), (value) => {
            const origin = add(probe.origin, scaled(probe.axes[i], value - world(probe, i)));
            room.recapture(probe, origin);
          });
        }
      }
      const reset = element('button', { type: 'button' }, this.controls, say('Start again'));
      reset.addEventListener('click', () => {
        room.probes.forEach((p, i) => Object.assign(p, copy(scene.probes[i]), { map: p.baked, recaptured: false }));
        room.roughness = null;
        room.camera = copy(scene.cameras[0]);
        this.build();
        this.redraw();
      });
    }

    turn(across, upwards) {
      const { camera } = this.room, away = sub(camera.position, camera.target), size = length(away);
      const up = unit(camera.up), height = dot(away, up) / size;
      const { right } = viewAxes(camera);
      const level = unit(cross(right, up)), angle = clamp(Math.asin(clamp(height, -1, 1)) + upwards, -1.5, 1.5);
      const turned = add(scaled(level, Math.cos(across)), scaled(right, Math.sin(across)));
      camera.position = add(camera.target, scaled(add(scaled(turned, Math.cos(angle)), scaled(up, Math.sin(angle))), size));
      this.redraw();
    }

    zoom(factor) {
      const { camera } = this.room;
      camera.position = add(camera.target, scaled(sub(camera.position, camera.target), clamp(factor, 0.5, 2)));
      this.redraw();
    }

    orbit() {
      const { canvas } = this, held = new Map();
      canvas.addEventListener('pointerdown', (event) => { canvas.setPointerCapture(event.pointerId); held.set(event.pointerId, [event.clientX, event.clientY]); });
      canvas.addEventListener('pointermove', (event) => {
        const before = held.get(event.pointerId);
        if (!before) return;
        const others = [...held.entries()].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
        const now = [event.clientX, event.clientY];
        held.set(event.pointerId, now);
        if (others.length) {
          const apart = (at) => Math.hypot(at[0] - others[0][0], at[1] - others[0][1]);
          this.zoom(apart(before) / Math.max(apart(now), 1));
        } else {
          this.turn(-(now[0] - before[0]) * 0.006, (now[1] - before[1]) * 0.006);
        }
      });
      for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, (event) => held.delete(event.pointerId));
      canvas.addEventListener('wheel', (event) => {
        if (!event.ctrlKey && this.options.wheel === false) return;  // a page of text scrolls
        event.preventDefault();
        this.zoom(Math.exp(event.deltaY * 0.001));
      }, { passive: false });
      canvas.addEventListener('keydown', (event) => {
        if (event.altKey || event.ctrlKey || event.metaKey) return;  // the browser's own
        const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
        if (way) this.turn(0.05 * way[0], 0.05 * way[1]);
        else if (event.key === '+' || event.key === '=') this.zoom(1 / 1.1);
        else if (event.key === '-') this.zoom(1.1);
        else return;
        event.preventDefault();
      });
    }
  }

  /** A room as a lesson's first step has it (app/web/web_view.h); what it starts again from. */
  window.boxprobeView = (room, view) => {
    const { scene } = room;
    scene.cameras.unshift(view.camera);
    if (scene.cameras.slice(1).some((camera) => camera.name === view.camera.name)) view.camera.name += ' of the lesson';
    room.camera = copy(view.camera);
    for (const object of scene.objects) object.visible = object.visible && !view.hidden.includes(object.name);
    for (const material of scene.materials) if (Object.hasOwn(view.roughness, material.name)) material.roughness = view.roughness[material.name];
    view.boxes.forEach((box, i) => [scene.probes[i], room.probes[i]].forEach((probe) => Object.assign(probe, { boxMin: [...box.min], boxMax: [...box.max] })));
    room.row = room.findRow(...view.technique.split('+')) || room.row;
  };

  /** `files`: address of a file that the JSON names; `panel` false: no controls. Begins when the host comes into view and resolves when the
   * first picture is loaded; `host.boxprobeRoom` is the Room. */
  window.boxprobeRoom = async (host, scene, options = {}) => {
    let hold = null;
    await new Promise((resolve) => {
      // What is seen at once need not wait for the page's first frame.
      const { top, bottom, width } = host.getBoundingClientRect();
      if (window === window.top && width > 0 && top < innerHeight && bottom >= 0) resolve();
      new IntersectionObserver((entries) => {
        const near = entries[entries.length - 1].isIntersecting;
        if (near) resolve();
        if (hold) hold.look(near);
      }, { rootMargin: '200px' }).observe(host);
    });
    const canvas = element('canvas', { width: 480, height: 300, tabindex: 0, role: 'img', 'aria-label': say('The scene: drag or use the arrow keys to look around, + and - to come nearer') });
    const gl = canvas.getContext('webgl2', { antialias: options.antialias !== false, preserveDrawingBuffer: true, alpha: false });
    if (!gl) {
      element('p', { class: 'room-said' }, host, say('This browser has no WebGL2: the pictures show what could be moved here.'));
      return;
    }
    try {
      const room = new Room(gl, copy(scene), options.files || ((name) => (scene.files ? scene.files[name] : name)));
      hold = new Hold(host, room);
      await hold.bring(options.prepare);
      room.given = false;
      hold.unsay();
      host.prepend(canvas);
      host.boxprobeRoom = room;
      if (options.panel !== false) host.boxprobePanel = new Panel(host, room, options, (error) => hold.fail(error));
      setTimeout(() => hold.look(hold.near));  // it may have left the view since
    } catch (error) {
      if (hold) hold.fail(error);
      else element('p', { class: 'room-said' }, host, say('The scene cannot be drawn here ({0}): the pictures show what could be moved.', error.message));
    }
  };
})();
