// @vitest-environment happy-dom
// The analysis asks for the draft's linearization and shows its modes; what is refused is said with its place.
import { cleanup, screen } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { analyse } from '../../core/control/analysis.ts';
import { systems } from '../../core/systems/all.ts';
import { scenarioOf } from '../../../tests/helpers.ts';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { AnalysisView } from './analysisView.tsx';

afterEach(cleanup);

const view = <AnalysisView save={() => {}} />;

test('the upright board: growing modes first, what the inputs reach', async () => {
  const app = testApp();
  app.actions.edit('case', () => app.cases.find(({ id }) => id === 'released')!.scenario);
  vi.spyOn(app.control, 'analyse').mockImplementation((file) => {
    const scenario = scenarioOf(file);
    return Promise.resolve({ ok: true, value: analyse(scenario, systems[scenario.system]!) } as never);
  });
  draw(view, { app });
  const table = await screen.findByTestId('modes-open');
  const first = table.querySelector('tbody th')!.textContent!.replaceAll('\u2212', '-');
  expect(parseFloat(first)).toBeGreaterThan(5);
  expect(screen.getByTestId('reach-summary').textContent).toContain('of 14');
  expect(screen.getByTestId('analysis').dataset['state']).toBe('ready');
});

test('a point that is none is said with its key', async () => {
  const app = testApp();
  vi.spyOn(app.control, 'analyse').mockImplementation(() =>
    Promise.resolve({ ok: false, path: 'at.alpha_fp', message: 'no steady motion' } as never),
  );
  draw(view, { app });
  expect((await screen.findByTestId('analysis-problem')).textContent).toContain('at.alpha_fp: no steady motion');
  expect(screen.getByTestId('analysis').dataset['state']).toBe('refused');
});
