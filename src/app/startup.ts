/** How the page begins: with a link, a file by address, the last work, or the first case. */
import type { App } from './app.ts';
import { Autosave } from './persistence/autosave.ts';
import type { BrowserStorage } from './persistence/browserStorage.ts';
import { workOf, type Work } from './persistence/savedWork.ts';
import { learnSystem, systemViews } from '../core/systems/registry.ts';
import { systemMetas } from './store.ts';

export interface Startup {
  autosave: Autosave;
  /** Once the page is drawn. */
  begin(): Promise<void>;
}

/** Puts the last work back at once, so that the first picture has its theme and panel. */
export function prepareStartup(app: App, toolIds: readonly string[], storage: BrowserStorage): Startup {
  const autosave = new Autosave(app, storage, systemMetas, toolIds);
  // An own system is read first, which takes what is not loaded yet.
  const own = autosave.descriptions;
  let last = own.length > 0 ? null : autosave.restore();
  if (own.length === 0) autosave.watch();
  const openLink = async (before: Work | null): Promise<boolean> => {
    const links = await import('./persistence/links.ts');
    return links.openLink(app, autosave, systemMetas, toolIds, before);
  };
  return {
    autosave,
    async begin() {
      if (own.length > 0) {
        // One that can't be read any more is told by `restore`, like all that can't be used.
        for (const text of own) await learnSystem(text).catch(() => {});
        last = autosave.restore();
        autosave.watch();
      }
      addEventListener('hashchange', () => {
        if (namesLink()) void openLink(autosave.suspendedWork ?? workOf(app.state));
      });
      void autosave.reopenMeshes();
      void import('./persistence/keptRuns.ts').then(
        ({ keepRuns }) => keepRuns(app, storage, systemViews),
        () => {},
      );
      const file = new URLSearchParams(location.search).get('file');
      if (!namesLink() || !(await openLink(last))) {
        if (file !== null || last?.file === undefined || last.file === null || !(await autosave.reopenFile(last.file)))
          app.actions.start();
      }
      if (file !== null) await (await import('./files/fileAddress.ts')).openFileAddress(app, file);
    },
  };
}

/** Anything after # that is no place in the page. */
function namesLink(): boolean {
  const place = location.hash.slice(1);
  return place !== '' && !document.getElementById(place);
}
