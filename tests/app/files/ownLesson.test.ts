// A lesson in a link: all of it, to the letter, and nothing of what is broken.
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { lessonIn, lessonInAddress, lessonLink } from '../../../src/app/files/ownLesson.ts';
import { openLessonLink } from '../../../src/app/persistence/links.ts';
import { kindOf } from '../../../src/app/files/fileKind.ts';
import { workingApp } from '../workingApp.ts';

test('it opens as it was written; every lesson of the page would fit', async () => {
  for (const name of ['1-rolling', '4-stiff', '6-locomotion']) {
    const text = readFileSync(`lessons/${name}.md`, 'utf8');
    const lesson = await lessonIn(new Blob([text]));
    const link = lessonLink(lesson)!;
    const app = workingApp();
    await openLessonLink(app, `#${link}`);
    expect(app.state.lesson.value).toEqual(lesson);
    expect(app.state.tool.value).toBe('lessons');
  }
});

test('what is no lesson is told and opens nothing; another link is none', async () => {
  const app = workingApp();
  expect(lessonInAddress('#v=1&case=ridden')).toBeNull();
  await openLessonLink(app, '#lesson=abc');
  expect(app.state.lesson.value).toBeNull();
  expect(app.state.messages.value.at(-1)).toMatchObject({
    kind: 'error',
    title: 'The lesson in the address can’t be read',
  });
});

test('one too long for addresses has no link; a file too large is not read', async () => {
  let seed = 1;
  const noise = Array.from({ length: 40_000 }, () =>
    String.fromCharCode(97 + ((seed = (seed * 48271) % 2147483647) % 26)),
  );
  expect(lessonLink(await lessonIn(new Blob([`# Noise\n${noise.join('')}`])))).toBeNull();
  await expect(lessonIn(new Blob(['x'.repeat(300_000)]))).rejects.toThrow('larger than the 200 kB');
  expect(await kindOf('week 3.MD', new Blob(['# A']))).toBe('lesson');
});
