// @vitest-environment happy-dom
// A menu by keyboard: arrows go round, Escape closes and gives the focus back, a disabled item cannot be chosen.
import { cleanup, fireEvent, render, screen } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { Menu } from '../../../src/ui/kit/menu.tsx';

afterEach(cleanup);

function menu() {
  const choose = vi.fn<(id: string) => void>();
  const items = ['csv', 'scenario', 'more'].map((id) => ({
    id,
    title: id,
    testId: id,
    disabled: id === 'scenario',
    choose: () => choose(id),
  }));
  render(
    <Menu label="Export" testId="menu" items={items}>
      Export
    </Menu>,
  );
  const button = screen.getByTestId('menu');
  fireEvent.click(button);
  const press = (key: string) => fireEvent.keyDown(document.activeElement!, { key });
  return { button, choose, press };
}

test('arrows, Home and End go over what can be chosen', () => {
  const { press } = menu();
  const now = () => document.activeElement?.getAttribute('data-testid');
  expect(now()).toBe('csv');
  press('ArrowDown');
  expect(now()).toBe('more');
  press('ArrowDown');
  expect(now()).toBe('csv');
  press('End');
  expect(now()).toBe('more');
  press('Home');
  expect(now()).toBe('csv');
});

test('Escape closes and gives the focus back to the button', () => {
  const { button, press } = menu();
  press('Escape');
  expect(screen.queryByRole('menuitem')).toBeNull();
  expect(document.activeElement).toBe(button);
  expect(button.getAttribute('aria-expanded')).toBe('false');
  press('ArrowDown');
  expect(screen.getAllByRole('menuitem')).toHaveLength(3);
});

test('a press elsewhere closes; a choice closes first and then acts', () => {
  const { button, choose } = menu();
  fireEvent.pointerDown(document.body);
  expect(screen.queryByRole('menuitem')).toBeNull();
  fireEvent.click(button);
  choose.mockImplementation(() => expect(document.activeElement).toBe(button));
  fireEvent.click(screen.getByTestId('more'));
  expect(choose.mock.calls).toEqual([['more']]);
  fireEvent.click(button);
  fireEvent.click(screen.getByTestId('scenario'));
  expect(choose.mock.calls).toEqual([['more']]);
});
