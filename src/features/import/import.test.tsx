// @vitest-environment happy-dom
// How a file was read: each column and what was understood can be changed, questions are one press, steps are asked for.
import { cleanup, fireEvent, screen, within } from '@testing-library/preact';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { draw, putOnStage, testApp } from '../../../tests/ui/page.tsx';
import { createFileState } from '../../app/files/fileState.ts';
import { dataView } from '../../core/motion/dataView.ts';
import { Trajectory } from '../../core/motion/trajectory.ts';
import type { App } from '../../app/app.ts';
import type { ColumnPlan, ImportChoices, ImportPlan, Question } from '../../csv/plan.ts';
import { AskDialog } from './askDialog.tsx';
import { drafted, sentTo, targetsOf, unitsFor } from './choices.ts';
import { DataDoor } from './dataDoor.tsx';
import { FileNotes } from './fileNotes.tsx';
import { ImportTool } from './importTool.tsx';
import { StageQuestions } from './questions.tsx';
import { words } from './words.ts';

afterEach(cleanup);

const column = (index: number, source: string, rest: Partial<ColumnPlan> = {}): ColumnPlan => ({
  index,
  source,
  title: source,
  name: source,
  unit: '',
  unitFrom: 'none',
  factor: 1,
  kind: 'plain',
  role: 'coordinate',
  ...rest,
});

const degrees: Question = {
  id: 'degrees',
  text: 'Are these angles in degrees?',
  answers: [
    { label: 'radians', choices: { angles: 'rad' } },
    { label: 'degrees', choices: { angles: 'deg' } },
  ],
  safest: 0,
  first: false,
};

const plan: ImportPlan = {
  encoding: 'utf-8',
  lineForm: 'plain',
  dress: null,
  separator: ';',
  decimal: ',',
  headerLines: [3],
  unitsLine: 4,
  firstRow: 5,
  width: 4,
  comments: ['#'],
  properties: [],
  system: 'cart-pendulum',
  columns: [
    column(0, 'time', { name: 't', kind: 'time', role: 'time', unit: 'ms', unitFrom: 'units row' }),
    column(1, 'X', { kind: 'length', unit: 'mm', unitFrom: 'title' }),
    column(2, 'theta', { kind: 'angle' }),
    column(3, 'remark', { name: null, role: 'unused' }),
  ],
  time: { columns: [0], form: 'number', unit: 'ms', factor: 1e-3, step: null },
  long: null,
  runs: 0,
  run: null,
  bodies: [],
  body: null,
  only: null,
  sparse: false,
  euler: null,
  up: 'z',
  rates: 'none',
  questions: [degrees],
  notes: [],
  repeated: [],
  preview: [
    ['0', '12,5', '0,1', 'start'],
    ['10', '12,6', '0,2', ''],
  ],
  shape: 'a shape',
};

/** The file of the plan on the stage of an app, and what is asked of it. */
function withFile(
  of: ImportPlan = plan,
  choices: ImportChoices = {},
): { app: App; readAgain: ReturnType<typeof vi.fn> } {
  const app = testApp();
  const { id: _, ...motion } = putOnStage(app, { version: 1, system: 'cart-pendulum', duration: 0.1 }, 'file');
  app.actions.showMotion({ ...motion, imported: { file: new Blob(['']), plan: of, choices } });
  app.actions.pause();
  const readAgain = vi.fn();
  app.actions.readAgain = readAgain;
  return { app, readAgain };
}

const choose = (testId: string, value: string) => fireEvent.change(screen.getByTestId(testId), { target: { value } });

describe('the view', () => {
  test('without a file it says what may be opened', () => {
    draw(<ImportTool />);
    expect(screen.getByText(words.none)).toBeTruthy();
  });

  test('shows each column with where it goes and its unit, and the first rows', () => {
    draw(<ImportTool />, withFile());
    const rows = within(screen.getByTestId('import-columns')).getAllByRole('row');
    expect(rows).toHaveLength(5);
    expect(screen.getByTestId<HTMLSelectElement>('import-target-1').value).toBe('X');
    expect(screen.getByTestId<HTMLSelectElement>('import-unit-1').value).toBe('mm');
    expect(screen.getByTestId<HTMLSelectElement>('import-target-3').value).toBe('');
    expect(screen.queryByTestId('import-unit-3')).toBeNull();
    expect(within(screen.getByTestId('import-preview')).getAllByRole('row')).toHaveLength(3);
    expect(screen.getByText(`${words.unitsLine(4)} ${words.firstRow(5)}`)).toBeTruthy();
  });

  test.each([
    ['import-unit-1', 'cm', { units: { X: 'cm' } }],
    ['import-unit-0', 's', { timeUnit: 's' }],
    ['import-target-3', 'theta_dot', { map: { theta_dot: 'remark' } }],
    ['import-target-2', 'X', { map: { X: 'theta', theta: null } }],
    ['import-target-2', '', { map: { theta: null } }],
    ['import-target-0', 'X', { time: null, map: { X: 'time' } }],
    ['import-target-2', 't', { time: 'theta', map: { theta: null } }],
    ['import-system', '', { system: null }],
    ['import-system', 'ripstik', { system: 'ripstik' }],
    ['import-time', '-1', { time: null }],
    ['import-time-unit', 'us', { timeUnit: 'us' }],
    ['import-angles', 'deg', { angles: 'deg' }],
    ['import-up', 'y', { up: 'y' }],
    ['import-encoding', 'windows-1252', { encoding: 'windows-1252' }],
    ['import-separator', '\t', { separator: '\t' }],
    ['import-decimal', '.', { decimal: '.' }],
    ['import-header', '2', { headerLine: 2 }],
  ])('%s to %j', (testId, value, choices) => {
    const { app, readAgain } = withFile();
    draw(<ImportTool />, { app });
    choose(testId, value);
    expect(readAgain.mock.calls).toEqual([[choices]]);
  });

  test('a system whose coordinates are still to be found: the columns are given places until it can be read', () => {
    const { app, readAgain } = withFile({ ...plan, system: null });
    const { state, actions } = createFileState();
    actions.setRefusedReading({
      choices: { system: 'cart-pendulum', map: { X: 'remark', theta: null } },
      message: 'for Cart-pendulum theta is missing; say which column each is',
    });
    const keep = vi.fn();
    app.actions.keepReading = keep;
    draw(<ImportTool />, { app: { ...app, state: { ...app.state, refusedReading: state.refusedReading } } });
    expect(screen.getByRole('alert').textContent).toContain('theta is missing');
    expect(screen.getByTestId<HTMLSelectElement>('import-system').value).toBe('cart-pendulum');
    expect(screen.getByTestId<HTMLSelectElement>('import-target-3').value).toBe('X');
    expect(screen.getByTestId<HTMLSelectElement>('import-target-2').value).toBe('');
    choose('import-target-2', 'theta');
    expect(readAgain.mock.calls).toEqual([[{ map: { theta: 'theta' } }]]);
    fireEvent.click(screen.getByTestId('import-keep'));
    expect(keep).toHaveBeenCalledTimes(1);
  });

  test('rates by differentiation are a switch; what was chosen can be taken back', () => {
    const { app, readAgain } = withFile(plan, { decimal: ',' });
    draw(<ImportTool />, { app });
    fireEvent.click(screen.getByTestId('import-rates'));
    fireEvent.click(screen.getByTestId('import-as-found'));
    expect(readAgain.mock.calls).toEqual([[{ rates: 'savitzky-golay' }], [null]]);
  });

  test('of several bodies and runs one is shown, and another is a choice away', () => {
    const { app, readAgain } = withFile({ ...plan, bodies: ['board', 'cart'], body: 'board', runs: 3, run: 2 });
    draw(<ImportTool />, { app });
    expect(screen.getByTestId<HTMLSelectElement>('import-body').value).toBe('board');
    expect(screen.getByTestId<HTMLSelectElement>('import-run').value).toBe('2');
    choose('import-body', 'cart');
    choose('import-run', '3');
    expect(readAgain.mock.calls).toEqual([[{ body: 'cart' }], [{ run: 3 }]]);
  });

  test('lengths are asked about only where one has no unit, nothing is taken back where nothing was chosen', () => {
    draw(<ImportTool />, withFile());
    expect(screen.queryByTestId('import-lengths')).toBeNull();
    expect(screen.queryByTestId('import-as-found')).toBeNull();
  });

  test('of counted rows the step can be changed; of data there are no axes and no rates', () => {
    const { app, readAgain } = withFile({
      ...plan,
      system: null,
      time: { columns: [], form: 'counted', unit: '', factor: 1, step: 1 / 60 },
    });
    draw(<ImportTool />, { app });
    expect(screen.queryByTestId('import-up')).toBeNull();
    expect(screen.queryByTestId('import-rates')).toBeNull();
    const step = screen.getByTestId<HTMLInputElement>('import-step');
    expect(step.value).toBe('1/60');
    fireEvent.focus(step);
    fireEvent.input(step, { target: { value: '0.01' } });
    fireEvent.blur(step);
    expect(readAgain.mock.calls).toEqual([[{ step: 0.01 }]]);
  });
});

describe('questions', () => {
  test('over the stage and in the tool: one press reads the file the other way', () => {
    const { app, readAgain } = withFile();
    draw(<StageQuestions />, { app });
    expect(screen.getByRole('group', { name: degrees.text })).toBeTruthy();
    expect(screen.getByTestId('stage-answer-degrees-0').textContent).toBe(words.shown('radians'));
    fireEvent.click(screen.getByTestId('stage-answer-degrees-1'));
    expect(readAgain.mock.calls).toEqual([[{ angles: 'deg' }]]);
  });

  test('nothing is asked where all is clear, nor what was asked before the file was read', () => {
    const { container } = draw(<StageQuestions />, withFile({ ...plan, questions: [{ ...degrees, first: true }] }));
    expect(container.textContent).toBe('');
  });

  test('a step that is asked for is offered as a fraction, taken by Enter, and may be refused', () => {
    const app = testApp();
    const { state, actions } = createFileState();
    const asked = { ...app, state: { ...app.state, pendingFile: state.pendingFile } };
    const answer = vi.fn();
    app.actions.answerPending = answer;
    const question: Question = {
      id: 'time-step',
      text: 'How far apart are the rows?',
      answers: [{ label: '1/60 s', choices: { step: 1 / 60 } }],
      safest: 0,
      first: true,
    };
    actions.setPendingFile({ name: 'report.csv', question });
    draw(<AskDialog />, { app: asked });
    expect(screen.getByTestId<HTMLInputElement>('step-field').value).toBe('1/60');
    fireEvent.click(screen.getByTestId('step-accept'));
    fireEvent.click(screen.getByTestId('step-cancel'));
    expect(answer.mock.calls).toEqual([[{ step: 1 / 60 }], [null]]);
  });

  test('another question that comes first is answered by its buttons', () => {
    const app = testApp();
    const { state, actions } = createFileState();
    const answer = vi.fn();
    app.actions.answerPending = answer;
    actions.setPendingFile({ name: 'clock.csv', question: { ...degrees, first: true } });
    draw(<AskDialog />, { app: { ...app, state: { ...app.state, pendingFile: state.pendingFile } } });
    fireEvent.click(screen.getByTestId('ask-1'));
    expect(answer.mock.calls).toEqual([[{ angles: 'deg' }]]);
  });
});

describe('around it', () => {
  test('beside the numbers of the moment: rows, columns, what could not be used, and the way to the view', () => {
    const { app } = withFile();
    const { columns } = app.state.motion.peek()!.trajectory;
    draw(<FileNotes />, { app });
    expect(screen.getByText(new RegExp(`${columns.length} ${words.columns}`))).toBeTruthy();
    expect(screen.getByText(words.clean)).toBeTruthy();
    fireEvent.click(screen.getByTestId('how-read'));
    expect(app.state.tool.peek()).toBe('import');
  });

  test('a run has no file notes', () => {
    const app = testApp();
    putOnStage(app, { version: 1, system: 'stiff-decay' });
    expect(draw(<FileNotes />, { app }).container.textContent).toBe('');
  });

  test('data leads to how it was read', () => {
    const { app } = withFile();
    const { id: _, ...motion } = app.state.motion.peek()!;
    app.actions.showMotion({
      ...motion,
      system: dataView('log.csv', [{ name: 'volts', label: 'volts', unit: 'V' }]),
      trajectory: Trajectory.of(['t', 'volts'], [new Float64Array([0, 1]), new Float64Array([2, 3])]),
    });
    draw(<DataDoor />, { app });
    fireEvent.click(screen.getByTestId('data-how'));
    expect(app.state.tool.peek()).toBe('import');
  });
});

describe('choices', () => {
  const meta = testApp().systemOf('cart-pendulum')!.meta;

  test('a column can go to each coordinate once, to the time, or nowhere', () => {
    const ids = targetsOf(plan.columns[1]!, meta).map(({ id }) => id);
    expect(ids).toEqual(['', 't', 'X', 'theta', 'X_dot', 'theta_dot']);
    expect(targetsOf(column(0, 'volts', { role: 'data' }), null).map(({ id }) => id)).toEqual(['', 't', 'volts']);
    expect(targetsOf(column(0, 'energy', { role: 'other' }), meta).map(({ id }) => id)).toEqual([...ids, 'energy']);
  });

  test('a column that stays where it is takes nothing from another', () => {
    expect(sentTo(plan.columns[1]!, 'X')).toEqual({ map: { X: 'X' } });
  });

  test('what is chosen stands in the view while it is read', () => {
    const shown = drafted(plan, { units: { X: 'cm' }, timeUnit: 's', map: { theta: 'remark' }, decimal: '.' }, meta);
    expect(shown.columns.map(({ name, unit }) => [name, unit])).toEqual([
      ['t', 's'],
      ['X', 'cm'],
      [null, ''],
      ['theta', ''],
    ]);
    expect(shown).toMatchObject({ decimal: '.', separator: ';', system: 'cart-pendulum' });
  });

  test('every kind is offered its units, and the one it has', () => {
    expect(unitsFor(plan.columns[1]!).map(({ id }) => id)).toEqual(['m', 'cm', 'mm', 'km', 'in', 'ft']);
    expect(unitsFor(column(0, 'x', { kind: 'length', unit: 'furlong' }))[0]!.id).toBe('furlong');
    expect(unitsFor(column(0, 'F'))).toHaveLength(1);
    expect(unitsFor(column(0, 'yaw', { role: 'data' })).map(({ id }) => id)).toContain('deg');
  });
});
