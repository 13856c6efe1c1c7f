import { test } from '@playwright/test';
import { chanceFrom } from '../../tools/soak/acts.ts';
import { Soak } from '../../tools/soak/soak.ts';
import { openPage, VIEWPORT } from './helpers.ts';
test.use({ viewport: VIEWPORT });
test('textures tmp', async ({ page }) => {
  const soak = await Soak.of(page, await openPage(page, () => {
    const w = window as unknown as { live: Map<WebGLTexture, string>; loseAll(): void };
    w.live = new Map();
    const p = WebGL2RenderingContext.prototype;
    const [c, d, b, t, s] = [p.createTexture, p.deleteTexture, p.bindTexture, p.texSubImage2D, p.texStorage2D];
    let bound: WebGLTexture | null = null;
    p.createTexture = function () { const x = c.call(this); if (x) w.live.set(x, 'new ' + performance.now().toFixed(0)); return x; };
    p.deleteTexture = function (x) { if (x) w.live.delete(x); d.call(this, x); };
    p.bindTexture = function (target, x) { bound = x; b.call(this, target, x); };
    p.texStorage2D = function (...a) { if (bound && w.live.has(bound)) w.live.set(bound, `${a[3]}x${a[4]} f${a[2]} ` + performance.now().toFixed(0)); s.apply(this, a); };
    p.texSubImage2D = function (...a: unknown[]) { const src = a.at(-1) as { width?: number }; if (bound && src && (src as HTMLCanvasElement).toDataURL) { const cv = src as HTMLCanvasElement; w.live.set(bound, `canvas ${cv.width}x${cv.height} ${(cv as unknown as {said?: string}).said ?? ''} ` + performance.now().toFixed(0)); } (t as (...q: unknown[]) => void).apply(this, a); };
    const f = CanvasRenderingContext2D.prototype.fillText;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) { (this.canvas as unknown as { said: string }).said = `"${text}" ${String(this.fillStyle)}`; (f as (...q: unknown[]) => void).call(this, text, ...rest); };
    document.addEventListener('webglcontextlost', () => w.live.clear(), true);
  }));
  const rounds = Number(process.env.ROUNDS ?? 6);
  for (let round = 0; round < rounds; round++) {
    const chance = chanceFrom(20171208);
    for (const name of ['run', 'keep', 'look', 'context lost'] as const) await soak.act(name, chance);
    const r = await soak.base();
    console.log('ROUND', round, r.textures, JSON.stringify(await page.evaluate(() => [...(window as unknown as { live: Map<WebGLTexture, string> }).live.values()])));
  }
});
