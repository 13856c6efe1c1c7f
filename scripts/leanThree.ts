// A Vite plugin: builds three.js from its single modules and without what this page never draws with. Half of what the
// first view loads is three, and of that half much is text of shaders, headsets, and methods that nobody calls.
import { readFileSync, readdirSync } from 'node:fs';
import { basename, dirname, join, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { withoutUnused } from './unusedMethods.ts';

const FOLDER = fileURLToPath(new URL('../node_modules/three/', import.meta.url));
const SOURCE = join(FOLDER, 'src/Three.js');
/** What takes three: the scene, and nothing beside it (`tests/repository/imports.test.ts`). */
const SCENE = fileURLToPath(new URL('../src/scene/', import.meta.url));

/**
 * Switches in three's shaders, and numbers of lights, that nothing of the scene turns on: their branches are left out.
 * What does would be drawn as if it did not, so `tests/repository/leanThree.test.ts` looks for the words that do.
 */
export const NEVER: Readonly<Record<string, string>> = {
  NUM_LIGHT_PROBE_GRIDS: 'LightProbe',
  NUM_RECT_AREA_LIGHTS: 'RectAreaLight',
  NUM_SPOT_LIGHTS: 'SpotLight',
  NUM_SPOT_LIGHT_COORDS: 'SpotLight',
  NUM_SPOT_LIGHT_MAPS: 'SpotLight',
  USE_ALPHAHASH: 'alphaHash',
  USE_ANISOTROPY: 'anisotropy',
  USE_AOMAP: 'aoMap',
  USE_BATCHING: 'BatchedMesh',
  USE_BATCHING_COLOR: 'BatchedMesh',
  USE_BUMPMAP: 'bumpMap',
  USE_CLEARCOAT: 'clearcoat',
  USE_DISPERSION: 'dispersion',
  USE_DISPLACEMENTMAP: 'displacementMap',
  USE_EMISSIVEMAP: 'emissiveMap',
  USE_GRADIENTMAP: 'gradientMap',
  USE_INSTANCING_MORPH: 'morphTexture',
  USE_IRIDESCENCE: 'iridescence',
  USE_LIGHTMAP: 'lightMap',
  USE_LIGHT_PROBES: 'LightProbe',
  USE_LOGARITHMIC_DEPTH_BUFFER: 'logarithmicDepthBuffer',
  USE_METALNESSMAP: 'metalnessMap',
  USE_MORPHCOLORS: 'morphAttributes',
  USE_MORPHNORMALS: 'morphAttributes',
  USE_MORPHTARGETS: 'morphAttributes',
  USE_REVERSED_DEPTH_BUFFER: 'reversedDepthBuffer',
  USE_ROUGHNESSMAP: 'roughnessMap',
  USE_SHEEN: 'sheen',
  USE_SKINNING: 'SkinnedMesh',
  USE_SPECULAR: 'specularIntensity',
  USE_SPECULARMAP: 'specularMap',
  USE_TRANSMISSION: 'transmission',
};

/** Materials' shaders that are never compiled: whoever does gets an error that says why. By file and what makes one. */
export const UNUSED_SHADERS: Readonly<Record<string, string>> = {
  distance: 'MeshDistanceMaterial',
  equirect: 'EquirectangularReflectionMapping',
  linedashed: 'LineDashedMaterial',
  meshmatcap: 'MeshMatcapMaterial',
  meshnormal: 'MeshNormalMaterial',
  meshtoon: 'MeshToonMaterial',
  points: 'PointsMaterial',
  vsm: 'VSMShadowMap',
};

/** Parts of the renderer that have nothing to do here: what it asks of them, and the word that whoever needs them would write. */
export const IDLE: Readonly<Record<string, { needed: RegExp; code: string }>> = {
  WebXRManager: {
    needed: /\bXR|\bxr\b/,
    code: `
import { EventDispatcher } from '../../core/EventDispatcher.js';
export class WebXRManager extends EventDispatcher {
  enabled = false;
  isPresenting = false;
  getEnvironmentBlendMode() {}
  setAnimationLoop() {}
  dispose() {}
}`,
  },
  WebGLUniformsGroups: {
    needed: /uniformsGroup/i,
    code: 'export const WebGLUniformsGroups = function () { this.dispose = function () {}; };',
  },
  WebGLEnvironments: {
    needed: /Equirectangular|Cube(?:Texture|Camera|RenderTarget|Re)/,
    code: `
export const WebGLEnvironments = function () {
  this.get = (texture) => texture ?? null;
  this.dispose = () => {};
}`,
  },
  WebGLOutput: { needed: /outputBufferType|setEffects/, code: 'export const WebGLOutput = function () {};' },
  FileLoader: { needed: /FileLoader/, code: 'export const FileLoader = function () {};' },
  TextureLoader: { needed: /TextureLoader/, code: 'export const TextureLoader = function () {};' },
  WebGLMorphtargets: { needed: /morph/i, code: 'export const WebGLMorphtargets = function () {};' },
};

/** One switch, or one number of lights, and nothing else. */
const ALONE = /^(?:defined\(\s*(\w+)\s*\)|(\w+)\s*>\s*0|\(\s*(\w+)\s*>\s*0\s*\))$/;

/** Without the branches of switches that are never on, and without comments and blanks that a compiler skips. */
export function leanShader(glsl: string): string {
  const out: string[] = [];
  /** One entry an open #if: whether lines count, and whether its own lines are left out. */
  const open: { kept: boolean; ours: boolean }[] = [];
  const plain = glsl.replace(/\/\*[\s\S]*?\*\//g, '').split('\n');
  for (const raw of plain) {
    const line = raw.replace(/\/\/.*$/, '').trim();
    const kept = open.every((block) => block.kept);
    const [, word, rest = ''] = /^#\s*(if|ifdef|ifndef|elif|else|endif)\b\s*(.*)$/.exec(line) ?? [];
    if (word === 'if' || word === 'ifdef' || word === 'ifndef') {
      const name = word === 'if' ? (ALONE.exec(rest)?.slice(1).find(Boolean) ?? '') : rest;
      const ours = name in NEVER;
      open.push({ kept: !ours || word === 'ifndef', ours });
      if (ours) continue;
    } else if (word === 'elif' && open.at(-1)?.ours) throw new Error(`leanShader cannot take "${line}" apart`);
    else if (word === 'else' && open.at(-1)?.ours) {
      open.at(-1)!.kept = !open.at(-1)!.kept;
      continue;
    } else if (word === 'endif' && open.pop()?.ours) continue;
    if (kept && line !== '') out.push(line);
  }
  if (open.length > 0) throw new Error('a shader of three has an #if without its #endif');
  return `${out.join('\n')}\n`;
}

/** A module of three as it is built, apart from its methods. */
function leanModule(path: string, code: string): string {
  const idle = IDLE[basename(path, '.js')];
  if (idle) return idle.code;
  const [, shader] = /[\\/]shaders[\\/]Shader(?:Chunk|Lib)[\\/](\w+)\.glsl\.js$/.exec(path) ?? [];
  if (shader === undefined) return code;
  const unused = dirname(path).endsWith('ShaderLib') && shader in UNUSED_SHADERS;
  const text = (glsl: string): string =>
    JSON.stringify(unused ? `#error ${shader} is left out (scripts/leanThree.ts)` : leanShader(glsl));
  return code.replace(/`([^`]*)`/g, (_, glsl: string) => text(glsl));
}

/** Names that a script imports or passes on, each with where from. */
function* imports(code: string): Generator<{ names: readonly string[]; from: string }> {
  for (const [, list = '', from] of code.matchAll(/\b(?:import|export)\b([^;'"`]*?)\bfrom\s*['"]([^'"]+)['"]/g)) {
    const inner = /\{([^}]*)\}/.exec(list)?.[1] ?? '';
    const names = inner.split(',').map((name) => name.replace(/\btype\b|\bas\b.*/g, '').trim());
    yield { names: names.filter(Boolean), from: from! };
  }
}

/** The modules of three that the scene takes, with all that these take, as built apart from their methods. */
function taken(users: readonly string[]): ReadonlyMap<string, string> {
  const homes = new Map<string, string>();
  for (const index of [SOURCE, join(FOLDER, 'src/Three.Core.js')])
    for (const { names, from } of imports(readFileSync(index, 'utf8')))
      for (const name of names) homes.set(name, join(FOLDER, 'src', from));
  const found = new Map<string, string>();
  const queue: string[] = [];
  const follow = (code: string, folder: string): void => {
    for (const { names, from } of imports(code)) {
      if (from === 'three') queue.push(...names.flatMap((name) => homes.get(name) ?? []));
      else if (from.startsWith('three/addons/')) queue.push(join(FOLDER, 'examples/jsm', from.slice(13)));
      else if (folder !== SCENE && from.startsWith('.')) queue.push(join(folder, from));
    }
  };
  for (const code of users) follow(code, SCENE);
  for (let path = queue.pop(); path !== undefined; path = queue.pop()) {
    if (found.has(path)) continue;
    const code = leanModule(path, readFileSync(path, 'utf8'));
    found.set(path, code);
    follow(code, dirname(path));
  }
  return found;
}

/** Every module of three that is built, by path, and which of its methods are left out. */
export function leanModules(): ReturnType<typeof withoutUnused> {
  const users = readdirSync(SCENE, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts'))
    .map((name) => readFileSync(join(SCENE, name), 'utf8'));
  return withoutUnused(taken(users), users);
}

export function leanThree(): Plugin {
  let modules: ReturnType<typeof leanModules> | null = null;
  return {
    name: 'lean-three',
    apply: 'build',
    enforce: 'pre',
    resolveId: (source) => (source === 'three' ? SOURCE : undefined),
    transform(code, id) {
      if (!/\/three\/(?:src|examples)\//.test(id)) return undefined;
      modules ??= leanModules();
      const path = id.replaceAll('/', sep);
      return { code: modules.get(path)?.code ?? leanModule(path, code), map: null };
    },
  };
}
