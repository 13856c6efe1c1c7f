// @vitest-environment happy-dom
// A number field takes numbers, units and expressions, says what it refuses, and steps; all that a person types stays.
import { cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { useState } from 'preact/hooks';
import type { NumberOrExpression } from '../../../src/core/scenario/types.ts';
import { NumberField } from '../../../src/ui/kit/numberField.tsx';
import type { NumberSpec } from '../../../src/ui/kit/useNumberField.ts';
import { draw } from '../page.tsx';

afterEach(cleanup);

function field(rules: Partial<NumberSpec> = {}) {
  const committed: (NumberOrExpression | undefined)[] = [];
  function Harness() {
    const [value, setValue] = useState<NumberOrExpression | undefined>(rules.value);
    return (
      <NumberField
        testId="field"
        symbol="x"
        spec={{
          path: 'initial.x',
          label: 'x',
          angle: false,
          base: rules.value,
          ...rules,
          value,
          commit(next) {
            committed.push(next);
            setValue(next);
          },
        }}
      />
    );
  }
  const drawn = draw(<Harness />);
  const input = screen.getByTestId<HTMLInputElement>('field');
  const type = (text: string) => {
    fireEvent.input(input, { target: { value: text } });
    fireEvent.keyDown(input, { key: 'Enter' });
  };
  return { ...drawn, input, type, committed };
}

test('what is typed is stored in SI; bare angles are degrees, expressions stay expressions', () => {
  const length = field({ value: 0.25, unit: 'm' });
  length.type('0.5 m');
  length.type('1/8');
  expect(length.committed).toEqual([0.5, '1/8']);
  cleanup();
  const angle = field({ value: '10 deg', unit: '°', angle: true });
  expect(angle.input.value).toBe('10');
  angle.type('12.5');
  angle.type('pi/8');
  angle.type('0.3 rad');
  expect(angle.committed).toEqual(['12.5 deg', 'pi/8', 0.3]);
});

test.each([
  ['soon', /soon/],
  ['1,5', /write decimals with a point/],
  ['-1', /must be greater than 0/],
  ['', /needs a number/],
])('refused with a reason, and not lost: %j', (typed, reason) => {
  const { input, type, committed, ui, container } = field({ value: 1, positive: true });
  type(typed);
  expect(committed).toEqual([]);
  expect(input.value).toBe(typed);
  expect(input.getAttribute('aria-invalid')).toBe('true');
  expect(container.querySelector(`#${CSS.escape(input.getAttribute('aria-describedby')!)}`)!.textContent).toMatch(
    reason,
  );
  expect([...ui.app.state.refusedFields.value.keys()]).toEqual(['initial.x']);
  fireEvent.keyDown(input, { key: 'Escape' });
  expect(input.value).toBe('1');
  expect(ui.app.state.refusedFields.value.size).toBe(0);
});

test('arrows step in the field’s own decade, Shift tenfold, and never past a bound', () => {
  const { input, committed } = field({ value: 9.81, max: 10 });
  fireEvent.keyDown(input, { key: 'ArrowUp' });
  fireEvent.keyDown(input, { key: 'ArrowDown', shiftKey: true });
  fireEvent.keyDown(input, { key: 'ArrowUp', shiftKey: true });
  fireEvent.keyDown(input, { key: 'ArrowUp', shiftKey: true });
  expect(committed).toEqual([9.91, 8.91, 9.91, 10]);
});

test('the dot says that the draft differs, and sets it back', () => {
  const { type, committed } = field({ value: 2 });
  expect(screen.queryByTitle(/differs/)).toBeNull();
  type('3');
  fireEvent.click(screen.getByTitle(/x differs from the case/));
  expect(committed).toEqual([3, 2]);
});

test('a field that leaves the page takes its refusal along', () => {
  const { type, ui, unmount } = field({ value: 1 });
  type('soon');
  expect(ui.app.state.refusedFields.value.size).toBe(1);
  unmount();
  expect(ui.app.state.refusedFields.value.size).toBe(0);
});

test('a number that is too long for its box is rounded while nobody edits it, and whole as soon as it has focus', () => {
  const { input, committed } = field({ value: 0.0685808540382, unit: 'm' });
  expect(input.value).toBe('≈0.06858');
  expect(input.title).toBe('0.0685808540382');
  fireEvent.focus(input);
  expect(input.value).toBe('0.0685808540382');
  fireEvent.blur(input);
  expect(input.value).toBe('≈0.06858');
  expect(committed).toEqual([]);
  // A step goes from the number itself.
  fireEvent.keyDown(input, { key: 'ArrowUp' });
  expect(committed[0]).toBeCloseTo(0.0685808540382, 1);
  expect(committed[0]).not.toBe(0.06858);
});

test('a short number and a formula stand as they are', () => {
  expect(field({ value: -1.23456 }).input.value).toBe('−1.23456');
  cleanup();
  expect(field({ value: 'sin(2*t)*0.123456' }).input.value).toBe('sin(2*t)*0.123456');
});
