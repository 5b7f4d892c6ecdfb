// What every page sends back: its picture in display colours, which pixels count, and what drew them.

/** Linear RGBA floats, rows from the bottom, as bytes of sRGB, rows from the top: as `boxprobe render` writes them. */
export function display(pixels, width, height) {
  const bytes = new Uint8Array(width * height * 4);
  for (let row = 0; row < height; row++) {
    for (let i = 0; i < width * 4; i++) {
      const linear = Math.min(Math.max(pixels[(height - 1 - row) * width * 4 + i], 0), 1);
      bytes[row * width * 4 + i] = i % 4 === 3 ? 255 : Math.round(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055));
    }
  }
  return bytes;
}

export async function report(gl, picture, mask) {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const renderer = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  await fetch('/picture', { method: 'POST', body: picture });
  await fetch('/mask', { method: 'POST', body: mask });
  await fetch('/done', { method: 'POST', body: renderer });
}

const failed = (problem) => fetch('/failed', { method: 'POST', body: String(problem && (problem.stack || problem.message) || problem) });
window.addEventListener('error', (event) => failed(event.error || event.message));
window.addEventListener('unhandledrejection', (event) => failed(event.reason));
