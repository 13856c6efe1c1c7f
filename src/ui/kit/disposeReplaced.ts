import { options, type VNode } from 'preact';

/** As Preact keeps it, under its permanent short names. */
interface Drawn extends VNode {
  /** What it drew. */
  __k: unknown;
  /** Its component, whose `__v` is what it drew as last. */
  __c: { __v: Drawn } | null;
}

const before = new WeakMap<Drawn, Drawn>();
const { vnode, diffed } = options;

/**
 * Lets go of what a component drew before. Preact draws a component that changed by itself as a copy of its node, while
 * the old node stays among the children that its parent was given, with everything it once drew: elements that are no
 * longer in the page, and motions of hundreds of megabytes that were their properties. The old node is never read
 * again (where the same child is drawn once more, Preact copies it), so its drawing can go.
 */
options.vnode = (made) => {
  vnode?.(made);
  const old = (made as Drawn).__c?.__v;
  if (old) before.set(made as Drawn, old);
};

options.diffed = (made) => {
  const now = made as Drawn;
  const old = before.get(now);
  if (old && old !== now && now.__c?.__v === now) old.__k = null;
  before.delete(now);
  diffed?.(made);
};
