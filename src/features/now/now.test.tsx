// @vitest-environment happy-dom
// The numbers at the playback time are those of the motion, in the units that stand beside them.
import { cleanup, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw, putOnStage, testApp } from '../../../tests/ui/page.tsx';
import { NowTool } from './nowPanel.tsx';
import { words } from './words.ts';

afterEach(cleanup);

test('without a motion it says how to get one', () => {
  draw(<NowTool />);
  expect(screen.getByText(words.empty)).toBeTruthy();
});

test('angles in degrees, multipliers by wheel', () => {
  const app = testApp();
  const file = app.cases.find(({ id }) => id === 'released')!.scenario;
  const { trajectory } = putOnStage(app, file);
  draw(<NowTool />, { app });
  const shown = (name: string) => Number(screen.getByTestId(`now-${name}`).textContent!.replace('\u2212', '-'));
  expect(shown('Z')).toBeCloseTo(trajectory.column('Z')![0]!, 4);
  expect(shown('alpha')).toBeCloseTo((trajectory.column('alpha')![0]! * 180) / Math.PI, 2);
  expect(shown('lambda_2')).toBeCloseTo(trajectory.column('lambda_2')![0]!, 3);
  const { label } = app.systemOf(file.system)!.contacts[0]!;
  expect(screen.getByText(`${label}, ${words.vertical}`)).toBeTruthy();
});
