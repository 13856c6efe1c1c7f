/** Surfaces: what a material of a mesh file looks like, by its name and colour. */
import type { ColourRole } from '../../core/model/system.ts';
import { type Material, Color, MeshStandardMaterial } from 'three';
import type { Palette } from '../palette.ts';
import { lightInStudio } from '../environment/softboxes.ts';

export interface Finish {
  kind: 'aluminium' | 'steel' | 'rubber' | 'urethane' | 'accent' | 'plastic';
  roughness: number;
  /** With an environment to mirror. */
  metalness: number;
  /** Without one, where softboxes are all there is to mirror: metals keep some colour of their own. */
  plainMetalness: number;
  /** Share of its own colour that shines through, for bodies that let light in. */
  glow: number;
}

const FINISHES: readonly (Finish & { words: RegExp })[] = [
  { kind: 'accent', words: /accent/, roughness: 0.5, metalness: 0, plainMetalness: 0, glow: 0.12 },
  {
    kind: 'rubber',
    words: /rubber|grip|tread|traction|pad|tyre|tire/,
    roughness: 0.92,
    metalness: 0,
    plainMetalness: 0,
    glow: 0,
  },
  { kind: 'urethane', words: /urethane|\bpu\b|wheel/, roughness: 0.28, metalness: 0, plainMetalness: 0, glow: 0.16 },
  {
    kind: 'steel',
    words: /steel|chrome|bolt|screw|bearing|axle|iron/,
    roughness: 0.32,
    metalness: 1,
    plainMetalness: 0.75,
    glow: 0,
  },
  { kind: 'aluminium', words: /alumin|alloy|metal/, roughness: 0.36, metalness: 0.9, plainMetalness: 0.7, glow: 0 },
];
const PLASTIC: Finish = { kind: 'plastic', roughness: 0.58, metalness: 0, plainMetalness: 0, glow: 0 };

/** The finish that a material's name asks for; plastic when it asks for none. */
export function finishOf(name: string): Finish {
  const lower = name.toLowerCase();
  return FINISHES.find((finish) => finish.words.test(lower)) ?? PLASTIC;
}

/** A lit surface for a material of a mesh file. `source.color` (Kd) is kept; textures are not. */
export function surfaceFrom(source: Material & { color?: Color }): MeshStandardMaterial {
  const finish = finishOf(source.name);
  const color = source.color?.clone() ?? new Color('#9aa1a8');
  const surface = new MeshStandardMaterial({
    name: source.name,
    color,
    roughness: finish.roughness,
    metalness: finish.plainMetalness,
    emissive: color.clone(),
    emissiveIntensity: finish.glow,
    transparent: source.opacity < 1,
    opacity: source.opacity,
  });
  surface.userData['finish'] = finish;
  lightInStudio(surface);
  return surface;
}

/** The colour of an accent: its body's, unless its name says otherwise. */
const roleOf = (name: string, role: ColourRole): ColourRole =>
  /front/i.test(name) ? 'first' : /back/i.test(name) ? 'second' : role;

/** Gives the surface its theme: the accent's colour, and a metal's look with or without an environment. */
export function dress(surface: MeshStandardMaterial, role: ColourRole, palette: Palette, environment: boolean): void {
  const finish = surface.userData['finish'] as Finish;
  surface.metalness = environment ? finish.metalness : finish.plainMetalness;
  if (finish.kind !== 'accent') return;
  surface.color.set(palette.role[roleOf(surface.name, role)]);
  surface.emissive.copy(surface.color);
}
