// @vitest-environment happy-dom
// Every case is a card under its heading; a search narrows them; a choice closes the gallery and takes the case.
import { cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { CaseMenu } from './caseMenu.tsx';
import { Gallery } from './gallery.tsx';
import { text } from './words.ts';

afterEach(cleanup);

function gallery() {
  const app = testApp();
  const load = vi.spyOn(app.actions, 'loadCase').mockImplementation(() => {});
  const onClose = vi.fn<() => void>();
  const { container } = draw(<Gallery onClose={onClose} />, { app });
  const cards = () =>
    [...container.querySelectorAll('[data-testid^="case-"]')].map((card) => card.getAttribute('data-testid')!);
  const search = (words: string) => fireEvent.input(screen.getByTestId('gallery-search'), { target: { value: words } });
  return { app, load, onClose, cards, search };
}

test('every case has a card or a choice on one, the panel’s own marked', () => {
  const { app, cards } = gallery();
  expect(new Set(cards())).toEqual(new Set(app.cases.map(({ id }) => `case-${id}`)));
  expect(screen.getByTestId(`case-${app.state.origin.value.id}`).getAttribute('aria-current')).toBe('true');
});

test('a search goes over system, figure and words, and says when there is none', () => {
  const { cards, search } = gallery();
  search('stiff decay');
  expect(cards()).toHaveLength(3);
  expect(screen.getByTestId('gallery-mathematics')).toBeTruthy();
  search('cart LQR');
  expect(cards()).toEqual(['case-cart-pendulum-lqr']);
  search('zebra');
  expect(cards()).toEqual([]);
  expect(screen.getByRole('status').textContent).toBe(text.none('zebra'));
});

test('Enter in the search takes the first that is found', () => {
  const { load, onClose, search } = gallery();
  search('cart LQR');
  screen.getByTestId('gallery-search').focus();
  fireEvent.keyDown(screen.getByTestId('gallery-search'), { key: 'Enter' });
  expect(onClose).toHaveBeenCalledTimes(1);
  expect(load.mock.calls).toEqual([['cart-pendulum-lqr']]);
});

test('the button names the case in the panel, and says when it is edited', () => {
  const app = testApp();
  draw(<CaseMenu />, { app });
  const { title, scenario } = app.state.origin.value;
  expect(screen.getByTestId('case-menu').getAttribute('aria-label')).toBe(`${text.title}: ${title}`);
  expect(screen.queryByText(text.edited)).toBeNull();
  cleanup();
  app.actions.edit('duration', () => ({ ...scenario, duration: 1.25 }));
  draw(<CaseMenu />, { app });
  expect(screen.getByText(text.edited)).toBeTruthy();
});

test('a card plays what happens while it is pointed at or has focus; with reduced motion it stands still', () => {
  const { cards } = gallery();
  const card = screen.getByTestId(cards()[0]!);
  const loops = () => screen.queryAllByTestId('card-loop').map((image) => image.getAttribute('src'));
  const id = cards()[0]!.slice('case-'.length);
  expect(loops()).toEqual([]);
  fireEvent.mouseEnter(card.parentElement!);
  expect(loops()).toEqual([expect.stringMatching(`^cases/${id}-(light|dark)-loop.webp$`)]);
  expect(screen.getByTestId('card-loop').hidden).toBe(true); // Until it has been loaded.
  fireEvent.load(screen.getByTestId('card-loop'));
  expect(screen.getByTestId('card-loop').hidden).toBe(false);
  fireEvent.mouseLeave(card.parentElement!);
  expect(loops()).toEqual([]);
  const still = vi.spyOn(window, 'matchMedia').mockReturnValue({ matches: true } as MediaQueryList);
  fireEvent.focusIn(card);
  expect(loops()).toEqual([]);
  still.mockRestore();
  fireEvent.focusIn(card);
  expect(loops()).toHaveLength(1);
});
