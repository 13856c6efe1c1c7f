// @vitest-environment happy-dom
import { cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { riderOf } from '../../core/systems/ripstik-rider/person.ts';
import { PersonFields, personOf } from './personFields.tsx';

afterEach(cleanup);

const field = (name: string): HTMLInputElement => screen.getByTestId(`person-${name}`);

test('whoever the parameters are of is found, and nobody in numbers that are nobody’s', () => {
  for (const person of [
    { height: 1.2, mass: 30 },
    { height: 1.83, mass: 83.5 },
  ])
    expect(personOf(riderOf(person), riderOf)).toEqual(person);
  expect(personOf({ ...riderOf({ height: 1.7, mass: 70 }), riderIxx: 8 }, riderOf)).toBeNull();
});

test('height and mass become the rider’s parameters, and are read from them', () => {
  const app = testApp();
  app.actions.edit('system', () => ({ version: 1, system: 'ripstik-rider' }));
  draw(<PersonFields />, { app, features: [] });
  // The rider that the system comes with is rounded: nobody's.
  expect([field('height').value, field('mass').value]).toEqual(['', '']);
  // Hips that turn as the system's own do need not be written.
  fireEvent.change(field('mass'), { target: { value: '60' } });
  expect({ hipIzz: 0.6, ...app.state.draft.peek().parameters }).toEqual(riderOf({ height: 1.75, mass: 60 }));
  expect([field('height').value, field('mass').value]).toEqual(['1.75', '60']);
  fireEvent.change(field('mass'), { target: { value: '80' } });
  expect(app.state.draft.peek().parameters).toEqual(riderOf({ height: 1.75, mass: 80 }));
  fireEvent.change(field('height'), { target: { value: '9' } });
  expect(app.state.draft.peek().parameters).toEqual(riderOf({ height: 1.75, mass: 80 }));
  fireEvent.change(field('height'), { target: { value: '' } });
  expect(app.state.draft.peek().parameters ?? {}).toEqual({});
});
