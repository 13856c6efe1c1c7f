import { type EventDispatcher, Mesh, type Object3D, Scene, ShaderMaterial, Texture } from 'three';
import { expect, test } from 'vitest';
import { drawingOf } from '../drawings.ts';
import { ripstikMeta } from '../../src/core/systems/ripstik/meta.ts';
import { Bodies } from '../../src/scene/actors/bodies.ts';
import { Forces } from '../../src/scene/overlay/forces.ts';
import { releaseUploads } from '../../src/scene/environment/lostContext.ts';
import { Lights } from '../../src/scene/environment/lights.ts';
import { palettes } from '../../src/scene/palette.ts';

test('a context that is lost: everything in the scene drops what the old state listens with, and stays whole', () => {
  const scene = new Scene();
  const palette = palettes.light;
  new Lights(scene, palette, 64);
  new Forces(scene, palette);
  const bodies = new Bodies(scene, palette);
  const { pairs, bodies: wearers } = drawingOf(ripstikMeta, {});
  bodies.setModels(pairs, wearers);
  const grain = new Texture();
  scene.add(new Mesh(undefined, new ShaderMaterial({ uniforms: { grain: { value: grain } } })));

  const told = new Map<object, number>();
  const listen = (one: EventDispatcher<{ dispose: object }>): void => {
    if (told.has(one)) return;
    told.set(one, 0);
    one.addEventListener('dispose', () => told.set(one, told.get(one)! + 1));
  };
  listen(grain as never);
  scene.traverse((object) => {
    if (object instanceof Mesh)
      for (const one of [object, object.geometry, object.material].flat()) listen(one as never);
  });
  expect(told.size).toBeGreaterThan(20);
  const before: Object3D[] = [];
  scene.traverse((object) => before.push(object));
  releaseUploads(scene, (material) => (material instanceof ShaderMaterial ? material.uniforms : undefined));
  expect([...told.values()].filter((times) => times !== 1)).toEqual([]);
  const after: Object3D[] = [];
  scene.traverse((object) => after.push(object));
  expect(after).toEqual(before);
});
