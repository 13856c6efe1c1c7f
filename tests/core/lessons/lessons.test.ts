// Every lesson that ships: read, its scenarios run, every answer computed again, and those with a closed form compared with it.
import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { feedbackOf } from '../../../src/core/control/design/feedback.ts';
import { answerOf } from '../../../src/core/lessons/answer.ts';
import { readLesson, type Block, type Subject } from '../../../src/core/lessons/lesson.ts';
import { isRight, readTyped } from '../../../src/core/lessons/typed.ts';
import { cases } from '../../../src/core/systems/registry.ts';
import { read } from '../exchange/exports.ts';

const files = readdirSync('lessons').filter((name) => /^\d.*\.md$/.test(name));
const rawOf = (subject: Subject): object =>
  'case' in subject ? cases.find(({ id }) => id === subject.case)!.scenario : subject.scenario;

async function answer(question: Extract<Block, { kind: 'question' }>): Promise<number> {
  const { scenario, system } = await read(rawOf(question.subject));
  return question.times * answerOf(scenario, system, question.ask, feedbackOf(scenario, system));
}

/** What a learner works out on paper, in the order of the questions; null where it is read off a run. */
const PAPER: Record<string, (number | null)[]> = {
  '1-rolling.md': [6, 3, 3],
  '2-caster.md': [2 * 0.05 * Math.sin(Math.PI / 6), null],
  '3-constraints.md': [(5 * 9.81 * (0.325 - 0.013)) / 0.52, (5 * 9.81 * (0.325 - 0.013) + 20 * 0.325) / 0.52],
  '4-stiff.md': [1 - 15 / 4, 1 - 15 / 8, (1 - 15 / 8) / (1 + 15 / 8)],
  // s² = (m1 + m2) g / (L (2 m1 + m2)): the radius of gyration about the centre of mass is L.
  '5-lqr.md': [Math.sqrt((0.4 * 9.81) / (2 * 0.4 - 0.1)), null, -0.3229866],
  '6-locomotion.md': [1.1, null],
};

test('there are six lessons', () => expect(files).toEqual(Object.keys(PAPER)));

describe.each(files)('%s', (file) => {
  const { blocks } = readLesson(readFileSync(`lessons/${file}`, 'utf8'));
  const questions = blocks.filter((block) => block.kind === 'question');

  test('its live parts are cases or right scenarios', async () => {
    for (const block of blocks) {
      if (block.kind !== 'live') continue;
      const raw = rawOf(block.subject) as Record<string, object>;
      for (const value of block.vary ? [block.vary.from, block.vary.to] : []) {
        const [group, name] = block.vary!.path;
        await read({ ...raw, [group]: { ...raw[group], [name]: value } });
      }
      await read(raw);
    }
  });

  test('every answer is there, and what paper says is right', async () => {
    const paper = PAPER[file]!;
    expect(questions.length).toBe(paper.length);
    for (const [k, question] of questions.entries()) {
      const value = await answer(question);
      expect(isRight(value, value, question.tolerance), question.text).toBe(true);
      const by = paper[k] ?? value;
      expect(isRight(by, value, question.tolerance), `${question.text} ${by} and not ${value}`).toBe(true);
      expect(isRight(value * 1.1, value, question.tolerance), question.text).toBe(false);
    }
  });
});

test('numbers are typed as people type them', () => {
  expect(readTyped('pi/8', 'rad')).toEqual({ value: Math.PI / 8 });
  expect(readTyped('22.5 deg', 'rad')).toEqual({ value: Math.PI / 8 });
  expect(readTyped('22.5°', 'rad')).toEqual({ value: Math.PI / 8 });
  expect(readTyped('30 cm', 'm')).toEqual({ value: 0.3 });
  expect(readTyped('0,3 m', 'm')).toEqual({ value: 0.3 });
  expect(readTyped('1/2', '1')).toEqual({ value: 0.5 });
  expect(readTyped('3 kg', 'm')).toEqual({ fault: 'this is no number in m' });
  expect(readTyped('', 'm')).toEqual({ fault: 'type a number' });
  expect(readTyped('t', 'm')).toHaveProperty('fault');
});

test('a live part names what is plotted', () => {
  const plotOf = (line: string) => {
    const [live] = readLesson(`# A\n\`\`\`live\ntitle: x\ncase: ridden\n${line}\n\`\`\``).blocks.filter(
      ({ kind }) => kind === 'live',
    );
    return (live as Extract<Block, { kind: 'live' }>).plot;
  };
  expect(plotOf('')).toBeNull();
  expect(plotOf('plot: alpha')).toEqual({ x: 't', y: ['alpha'] });
  expect(plotOf('plot: alpha over_dot psi')).toEqual({ x: 't', y: ['alpha', 'over_dot', 'psi'] });
  expect(plotOf('plot: Y Z over X')).toEqual({ x: 'X', y: ['Y', 'Z'] });
});

test.each([
  ['# A\n```live\ntitle: x\ncase: ridden\nplot: Y,X\n```', /line 5: right would be: plot: alpha beta/],
  ['no title', /line 1: a lesson begins with its title/],
  ['# A\n```live\ntitle: x', /line 2: this block has no end/],
  ['# A\n```live\ntitle: x\n```', /line 2: this block needs a line "scenario: …"/],
  ['# A\n```live\ncode: x\n```', /line 3: a line here is "key: value"/],
  ['# A\n```question\nask: x\nscenario: {\nanswer: end x\n```', /line 4: the scenario is JSON/],
  ['# A\n```question\nask: x\ncase: ridden\nanswer: 3\n```', /line 5: an answer is computed/],
  ['# A\n```live\ntitle: x\ncase: ridden\nvary: initial.alpha 1 0\n```', /line 5: right would be/],
  [`# A\n${'x'.repeat(70_000)}`, /at most 60000 characters/],
])('a wrong lesson is told with its line', (text, why) => {
  expect(() => readLesson(text)).toThrow(why);
});
