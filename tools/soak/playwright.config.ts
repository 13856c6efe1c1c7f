// The long runs: `npm run soak` and `npm run big`. The page, its server and its browser are those of the tests of every day.
import { defineConfig } from '@playwright/test';
import usual from '../../playwright.config.ts';

const root = new URL('../../', import.meta.url).pathname;

export default defineConfig({
  ...usual,
  testDir: '.',
  testMatch: '*.spec.ts',
  outputDir: `${root}.cache/soak-results`,
  timeout: 0,
  retries: 0,
  reporter: [['list']],
  use: { ...usual.use, actionTimeout: 60_000 },
  webServer: { ...(usual.webServer as { command: string; url: string }), cwd: root, reuseExistingServer: false },
});
