/** Leads the person to a field of the draft, wherever it is folded away. */

/** The field of a path, or the nearest to it: what is wrong with a whole section is shown at its first field. */
function fieldOf(path: string, root: ParentNode): HTMLElement | null {
  for (let known = path; known !== ''; known = known.slice(0, Math.max(known.lastIndexOf('.'), 0))) {
    const name = CSS.escape(known);
    const found = root.querySelector<HTMLElement>(`[data-path="${name}"], [data-path^="${name}."]`);
    if (found) return found;
  }
  return null;
}

/** @returns whether there is such a field */
export function goToField(path: string, root: ParentNode = document): boolean {
  const field = fieldOf(path, root);
  if (!field) return false;
  for (let fold = field.closest('details'); fold; fold = fold.parentElement?.closest('details') ?? null)
    fold.open = true;
  field.scrollIntoView({ block: 'center' });
  field.focus({ preventScroll: true });
  if (field instanceof HTMLInputElement) field.select();
  return true;
}
