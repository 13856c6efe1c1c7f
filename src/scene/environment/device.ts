/** What the browser and the machine can do. */

/** The browser gives no WebGL 2 context. */
export class NoWebGlError extends Error {
  override name = 'NoWebGlError';
  constructor() {
    super(
      'This browser gives no WebGL 2, which the 3-D view needs; switch on hardware acceleration or try another browser. Plots and numbers work without it.',
    );
  }
}

/** Whether the renderer's name is that of a program on the processor. */
export function isSoftwareRenderer(name: string): boolean {
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** The canvas's WebGL 2 context, and whether a program on the processor draws it. Throws `NoWebGlError`. */
export function openContext(
  canvas: HTMLCanvasElement,
  alpha = false,
): { gl: WebGL2RenderingContext; software: boolean } {
  const gl = canvas.getContext('webgl2', { antialias: true, alpha, depth: true, powerPreference: 'high-performance' });
  if (!gl) throw new NoWebGlError();
  const naming = gl.getExtension('WEBGL_debug_renderer_info');
  return {
    gl,
    software: isSoftwareRenderer(String(gl.getParameter(naming ? naming.UNMASKED_RENDERER_WEBGL : gl.RENDERER))),
  };
}

/** Runs once when the browser has nothing better to do; returns a number above zero. */
export function whenIdle(work: () => void): number {
  if (typeof requestIdleCallback === 'function') return requestIdleCallback(work, { timeout: 2000 });
  return window.setTimeout(work, 300);
}

/** Tells when the canvas loses its context and gets it back; what it returns stops that. */
export function watchContext(canvas: HTMLCanvasElement, lost: () => void, restored: () => void): () => void {
  const leave = (event: Event): void => {
    event.preventDefault(); // without it the browser never gives the context back
    lost();
  };
  canvas.addEventListener('webglcontextlost', leave);
  canvas.addEventListener('webglcontextrestored', restored);
  return () => {
    canvas.removeEventListener('webglcontextlost', leave);
    canvas.removeEventListener('webglcontextrestored', restored);
  };
}
