/** What the page has to know of a system's drawing before its meshes are there. */

/** The model that a body wears; others wear one of their own name. */
const SHARED: Readonly<Record<string, Readonly<Record<string, string>>>> = {
  ripstik: { 'front-caster': 'caster', 'back-caster': 'caster' },
};
/** Systems with a close-up view. */
const CLOSE_UP: ReadonlySet<string> = new Set(['ripstik']);
/** Systems that go somewhere, and can be looked at from aboard. */
const RIDDEN: ReadonlySet<string> = new Set([
  'ripstik',
  'bicycle',
  'casterboard-robot',
  'chaplygin-sleigh',
  'rolling-wheel',
]);

/** Names of the meshes that a person can replace, in the order of the bodies. */
export function modelsOf(meta: { id: string; bodies: readonly { id: string }[] }): readonly string[] {
  return [...new Set(meta.bodies.map(({ id }) => SHARED[meta.id]?.[id] ?? id))];
}

export const canRide = (systemId: string): boolean => RIDDEN.has(systemId);

export const hasCloseUp = (systemId: string): boolean => CLOSE_UP.has(systemId);
