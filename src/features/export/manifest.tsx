import type { Feature } from '../../ui/feature.ts';
import { ExportDoor } from './exportDoor.tsx';
import { ExportMenu } from './exportMenu.tsx';
import { words } from './words.ts';

export const exporting: Feature = {
  id: 'export',
  order: 100,
  topEnd: ExportMenu,
  dialog: ExportDoor,
  commands: [
    {
      id: 'export-csv',
      label: words.menu.csv,
      enabled: ({ state }) => state.motion.value !== null,
      perform: ({ actions }) => actions.exportCsv(),
    },
    { id: 'save-scenario', label: words.menu.scenario, perform: ({ actions }) => actions.saveScenario() },
    { id: 'export', label: words.menu.more, perform: ({ actions }) => actions.openDialog('export') },
  ],
};
