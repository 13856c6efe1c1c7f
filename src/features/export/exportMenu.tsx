/** In the bar at the top: what can leave the page at once, and the door to the rest. */
import { useUi } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { Menu } from '../../ui/kit/menu.tsx';
import { words } from './words.ts';

export function ExportMenu() {
  const { state, actions } = useUi().app;
  return (
    <Menu
      label={words.title}
      testId="export-menu"
      align="right"
      items={[
        {
          id: 'csv',
          title: words.menu.csv,
          testId: 'export-csv',
          disabled: state.motion.value === null,
          choose: actions.exportCsv,
        },
        { id: 'scenario', title: words.menu.scenario, testId: 'export-scenario', choose: actions.saveScenario },
        {
          id: 'more',
          title: words.menu.more,
          testId: 'export-more',
          choose: () => actions.openDialog('export'),
        },
      ]}
    >
      <Icon name="export" />
      <span class="word">{words.title}</span>
    </Menu>
  );
}
