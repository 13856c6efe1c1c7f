import { NeutralToneMapping, PCFShadowMap, WebGLRenderer } from 'three';

/** A renderer on a canvas's own context, set up for the stage. */
export function rendererFor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext, alpha = false): WebGLRenderer {
  const renderer = new WebGLRenderer({ canvas, context, alpha });
  renderer.toneMapping = NeutralToneMapping; // keeps the colours that mean something
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.info.autoReset = false; // a picture may have an inset
  return renderer;
}
