/** In the bar at the top: what can leave the page at once, and the door to the rest. */
import { useCommand } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { Menu } from '../../ui/kit/menu.tsx';
import { firstWords } from './firstWords.ts';

export function ExportMenu() {
  const items = [
    { id: 'csv', command: useCommand('export-csv') },
    { id: 'scenario', command: useCommand('save-scenario') },
    { id: 'more', command: useCommand('export') },
  ];
  return (
    <Menu
      label={firstWords.title}
      testId="export-menu"
      align="right"
      items={items.map(({ id, command }) => ({
        id,
        title: command.label,
        testId: `export-${id}`,
        disabled: command.disabled,
        choose: command.perform,
      }))}
    >
      <Icon name="export" />
      <span class="word">{firstWords.title}</span>
    </Menu>
  );
}
