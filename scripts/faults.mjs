// npm run faults: tests/browser/faults.spec.ts, whose tests tell what they injected and what the page said of it; that goes into docs/robustness.md.
import { join } from 'node:path';
import { cache, main, readJson, root, run, writeTable } from './setup.mjs';

const specsIn = ({ specs = [], suites = [] }) => [...specs, ...suites.flatMap(specsIn)];

main(async () => {
  const { code } = await run(process.execPath, [join(root, 'scripts/test.mjs'), 'browser', 'faults.spec'], {
    show: true,
  });
  if (code !== 0) return code;
  const annotations = specsIn(readJson(join(cache, 'browser.json'))).flatMap((spec) =>
    spec.tests.flatMap((test) => test.annotations),
  );
  const rows = annotations
    .filter(({ type }) => type === 'fault')
    .map(({ description }) => `| ${JSON.parse(description).join(' | ')} | nothing |`);
  writeTable('faults', ['| fault | what the page says | lost |', '|---|---|---|', ...rows, '', '`npm run faults`']);
  return 0;
});
