/** How a visit begins: with a link, a file by address, the last work, or the first case. */
import { Keeper } from './persistence/autosave.ts';
import type { Work } from './persistence/savedWork.ts';
import { browserShelf } from './persistence/browserStorage.ts';
import { systemMetas } from './store.ts';
import type { App } from './types.ts';

export interface Visit {
  keeper: Keeper;
  /** Once the page is drawn. */
  begin(): Promise<void>;
}

/** Puts the last work back at once, so that the first picture has its theme and panel. */
export function prepareVisit(app: App, toolIds: readonly string[]): Visit {
  const keeper = new Keeper(app, browserShelf, systemMetas, toolIds);
  const last = keeper.restore();
  keeper.watch();
  const openLink = async (before: () => Work | null): Promise<boolean> => {
    const links = await import('./persistence/links.ts');
    return links.openLink(app, keeper, systemMetas, toolIds, before());
  };
  return {
    keeper,
    async begin() {
      addEventListener('hashchange', () => {
        if (namesLink())
          void import('./persistence/links.ts').then((links) =>
            links.openLink(app, keeper, systemMetas, toolIds, keeper.aside ?? links.workBefore(app)),
          );
      });
      void keeper.reopenMeshes();
      const file = new URLSearchParams(location.search).get('file');
      if (!namesLink() || !(await openLink(() => last))) {
        if (file !== null || last?.file === undefined || last.file === null || !(await keeper.reopenFile(last.file)))
          app.actions.open();
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
