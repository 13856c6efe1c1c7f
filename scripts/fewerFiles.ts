// How the first view's scripts are cut: one file of what page and worker share, one of the page's, one of
// the worker's, one of what draws the first bodies.
// Cut wherever a later part shares something with them, they were forty, and compressed worse.
import { fileURLToPath } from 'node:url';

interface Modules {
  getModuleInfo(id: string): { importedIds: readonly string[]; dynamicallyImportedIds: readonly string[] } | null;
}

const source = (path: string): string => fileURLToPath(new URL(`../src/${path}`, import.meta.url));
const PAGE = source('main.tsx');
const WORKER = source('compute/worker.ts');
/** The worker's first task. */
const TASK = source('compute/services/run.ts');
/** What draws the first motion: a board and who stands on it. */
const DRAWN = ['core/geometry/drawings.ts', 'core/systems/ripstik-rider/drawing.ts'].map(source);

/** Modules that some take, and these in turn; `later`: also what they load later. */
function closure(from: readonly string[], modules: Modules, later = false): ReadonlySet<string> {
  const found = new Set<string>();
  const queue = [...from];
  for (let id = queue.pop(); id !== undefined; id = queue.pop()) {
    if (found.has(id)) continue;
    found.add(id);
    const info = modules.getModuleInfo(id);
    queue.push(...(info?.importedIds ?? []), ...((later && info?.dynamicallyImportedIds) || []));
  }
  return found;
}

/**
 * For rolldown: which of the four a module is in; null: it comes later, or begins one of the two. What the worker may
 * ever take is in no file of the page's own: that would run the page in the worker.
 */
export function fileOf(): (id: string, modules: Modules) => string | null {
  let sets: Record<'page' | 'worker' | 'first' | 'drawn', ReadonlySet<string>> | null = null;
  return (id, modules) => {
    sets ??= {
      page: closure([PAGE], modules),
      worker: closure([WORKER], modules, true),
      first: closure([WORKER, TASK], modules),
      drawn: closure(DRAWN, modules),
    };
    if (id === PAGE || id === WORKER) return null;
    if (sets.page.has(id)) return sets.worker.has(id) ? 'shared' : 'page';
    if (sets.first.has(id)) return 'compute';
    return sets.drawn.has(id) ? 'drawings' : null;
  };
}
