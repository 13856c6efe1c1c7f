// Finds a browser for the tests, or brings one, without a question. Every candidate is tried by launching it: an
// executable that is there may still lack its libraries, or be a stub that asks to install the real one.
import { existsSync, readFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { Plain, run, runPackage } from './setup.mjs';

const WAYS = `There is no browser for the tests. Any one of these mends it:
  install Google Chrome, Chromium or Microsoft Edge
  npx playwright install --with-deps chromium
  RIPSTIK_BROWSER=/path/to/chrome npm test`;

/** The browser that Playwright downloads and knows the place of. */
const MANAGED = '';

/** Path of a browser that launches here; '' stands for the one that Playwright manages. */
export async function findBrowser(say = console.log) {
  const named = process.env.RIPSTIK_BROWSER;
  if (named) {
    const reason = await launchFailure(named);
    if (reason) throw new Plain(`RIPSTIK_BROWSER names ${named}, which does not launch: ${reason}`);
    return named;
  }
  const found = await firstOf([MANAGED, ...systemBrowsers()]);
  if (found !== null) return found;
  say('No browser for the tests yet: trying to install one …');
  return installBrowser(say);
}

async function installBrowser(say) {
  const isRoot = process.platform === 'linux' && process.getuid() === 0;
  const limit = { timeout: 900_000 };
  await runPackage('@playwright/test/cli.js', ['install', 'chromium'], limit);
  let reason = await launchFailure(MANAGED);
  // Downloaded but not launching means missing libraries. Only root installs those: sudo might ask for a password.
  if (reason && !/Executable doesn't exist/.test(reason) && isRoot) {
    await runPackage('@playwright/test/cli.js', ['install-deps', 'chromium'], limit);
    reason = await launchFailure(MANAGED);
  }
  if (!reason) return MANAGED;
  if (isRoot && isDebian()) {
    const options = { ...limit, env: { DEBIAN_FRONTEND: 'noninteractive' } };
    const packages = ['chromium', 'libegl1', 'libgl1-mesa-dri', 'fonts-liberation'];
    await run('apt-get', ['update', '-qq'], options);
    const apt = await run('apt-get', ['install', '-y', '-qq', '--no-install-recommends', ...packages], options);
    const found = await firstOf(systemBrowsers());
    if (found !== null) return found;
    say(`apt-get: ${apt.output.trim().split('\n').pop()}`);
  }
  throw new Plain(WAYS);
}

async function firstOf(candidates) {
  for (const candidate of candidates) if (!(await launchFailure(candidate))) return candidate;
  return null;
}

/** Why a browser does not launch, in one line; null when it does. */
async function launchFailure(path) {
  if (path !== MANAGED && !existsSync(path)) return 'there is no such file';
  const { chromium } = await import('@playwright/test'); // not above: it may have been installed only just now
  try {
    const browser = await chromium.launch({ executablePath: path || undefined, timeout: 30_000 });
    await browser.close();
    return null;
  } catch (error) {
    return error.message.split('\n')[0];
  }
}

/** The places where Chrome, Chromium and Edge are, of those that exist. */
function systemBrowsers() {
  return places().filter((path) => existsSync(path));
}

function places() {
  const env = process.env;
  if (process.platform === 'darwin') {
    const apps = ['Google Chrome', 'Chromium', 'Microsoft Edge'];
    const folders = ['/Applications', join(env.HOME || '', 'Applications')];
    return folders.flatMap((folder) => apps.map((app) => `${folder}/${app}.app/Contents/MacOS/${app}`));
  }
  if (process.platform === 'win32') {
    const programs = ['Google/Chrome/Application/chrome.exe', 'Microsoft/Edge/Application/msedge.exe'];
    const folders = [env.PROGRAMFILES, env['PROGRAMFILES(X86)'], env.LOCALAPPDATA].filter(Boolean);
    return folders.flatMap((folder) => programs.map((program) => join(folder, program)));
  }
  const names = ['google-chrome-stable', 'google-chrome', 'chromium', 'chromium-browser', 'microsoft-edge'];
  const folders = [...(env.PATH || '').split(delimiter).filter(Boolean), '/usr/bin', '/snap/bin'];
  return [...new Set(names.flatMap((name) => folders.map((folder) => join(folder, name))))];
}

function isDebian() {
  return existsSync('/etc/os-release') && /^ID="?debian"?$/m.test(readFileSync('/etc/os-release', 'utf8'));
}
