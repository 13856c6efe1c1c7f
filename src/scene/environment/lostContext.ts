/**
 * What three holds for a context that is lost. It begins anew when the context comes back, but the listeners that its
 * old state put on geometries, textures and targets stay, and with them that state, every shader's uniforms and all:
 * one more with every loss. Told that they go, they drop their listeners; what is still in the scene is sent to the
 * graphics card again when it is next drawn, which has to happen anyway.
 */
import { type BufferGeometry, type Material, type Object3D, Texture } from 'three';

/** Instances and lights, with their shadows, have something to let go of their own; the types know it of a few. */
type Held = Object3D & { geometry?: BufferGeometry; material?: Material | Material[]; dispose?(): void };

/**
 * To be called between the loss and the return. Textures that no material shows now are their owners' to let go.
 * @param uniformsOf what the renderer sends with a material: among it textures of three's own, which every renderer shares
 */
export function releaseUploads(
  scene: Object3D,
  uniformsOf: (material: Material) => Readonly<Record<string, { value: unknown }>> | undefined,
): void {
  const gone = new Set<{ dispose?(): void }>();
  scene.traverse((object: Held) => {
    gone.add(object);
    if (object.geometry) gone.add(object.geometry);
    for (const material of [object.material ?? []].flat()) {
      gone.add(material);
      const sent = Object.values(uniformsOf(material) ?? {}).map(({ value }) => value);
      for (const value of [...Object.values(material), ...sent]) if (value instanceof Texture) gone.add(value);
    }
  });
  for (const one of gone) one.dispose?.();
}
