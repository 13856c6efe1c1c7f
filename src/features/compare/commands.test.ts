// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { sheetOf } from '../../app/commands.ts';
import { putOnStage, testApp } from '../../../tests/ui/page.tsx';
import { compare } from './manifest.tsx';
import { firstWords } from './firstWords.ts';

test('B pins the run on the stage, and the sheet says so', () => {
  expect(sheetOf(compare.commands!)).toEqual([['B', firstWords.pinKey]]);
  const app = testApp();
  putOnStage(app, { version: 1, system: 'ripstik', duration: 0.02 });
  compare.commands!.find(({ id }) => id === 'pin')!.perform!(app);
  expect(app.state.pinned.value).toHaveLength(1);
});
