// `ripstik link`: a scenario as the part of the page's address after #, and back.
import { spawnSync } from 'node:child_process';
import { expect, test } from 'vitest';

const ripstik = (input: string, ...args: string[]) =>
  spawnSync(process.execPath, ['--import', 'tsx', 'src/cli/main.ts', ...args], { encoding: 'utf8', input });

const PENDULUM = `system "Pendulum"
coordinate theta [rad] = 0.5
kinetic 1/2 theta'^2
potential -9.81 cos(theta)
`;
const scenario = (description: string): string =>
  JSON.stringify({ version: 1, system: { description }, initial: { theta_dot: '10 deg' } });

test('a scenario with a description goes into a link, and a link in its place gives the same numbers', () => {
  const { stdout: link, status } = ripstik(scenario(PENDULUM), 'link', '-');
  expect(status).toBe(0);
  expect(link).toMatch(/^#v=1&\S+\n$/);
  const [file, linked] = [
    ripstik(scenario(PENDULUM), 'point', '-'),
    // As a mail program writes it.
    ripstik('', 'point', `https://a.b/${link.trim().replace('#', '%23').replaceAll('=', '%3D')}.`),
  ];
  expect(linked.stdout).toBe(file.stdout);
  expect(JSON.parse(linked.stdout)).toMatchObject({ q: [0.5], v: [Math.PI / 18] });
}, 60_000);

test('what no link carries is said in one line, with the way out', () => {
  let [x, noise] = [1, ''];
  while (noise.length < 39_000) noise += `# ${(x = (x * 48271) % 2147483647).toString(36)}\n`;
  const long = ripstik(scenario(PENDULUM + `# ${noise.replaceAll('\n# ', ' ')}`), 'link', '-');
  expect(long.status).toBe(2);
  expect(long.stderr).toMatch(
    /^ripstik: a link of \d+ characters is more than the 16000 that addresses carry; save the scenario as a file instead\n$/,
  );
}, 60_000);
