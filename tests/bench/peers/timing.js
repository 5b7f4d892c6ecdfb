// What the pages share: the scene's plain values, marks at which the server reads the clock, frames in a row, and what is sent back.

export const config = await (await fetch('/scene/config.json')).json();

export const mark = (name) => fetch('/mark/' + name, { method: 'POST' });

/** Waits until the canvas is drawn: a pixel is read. */
export function finish(gl) {
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
}

/** Waits until the driver has done all of it, pictures that no pixel of the canvas needs included. */
export async function settled(gl) {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  do {
    await new Promise((resolve) => setTimeout(resolve, 5));
  } while (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED);
}

/** Frames that are drawn whole one after the other, and the picture of the first one. `draw` draws into `canvas`; `inCapture`: frames
 * drawn between the marks of the capture. */
export async function timed(gl, canvas, draw, inCapture = 0) {
  const frames = config.frames;
  draw();
  const picture = await new Promise((resolve) => canvas.toBlob(resolve));
  await mark('picture');
  for (let i = 0; i < 5; i++) {
    draw();
    finish(gl);
  }
  await mark('warm');
  for (let i = 0; i < frames; i++) {
    draw();
    finish(gl);
  }
  await mark('end');
  await fetch('/picture', { method: 'POST', body: picture });
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const renderer = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  await fetch('/done', { method: 'POST', body: JSON.stringify({ frames, inCapture, renderer }) });
}

const failed = (problem) => fetch('/failed', { method: 'POST', body: String(problem && (problem.stack || problem.message) || problem) });
window.addEventListener('error', (event) => failed(event.error || event.message));
window.addEventListener('unhandledrejection', (event) => failed(event.reason));
