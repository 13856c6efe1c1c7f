// The browser tests run on the built page, served from a sub-path. `npm test -- browser` builds it and finds a browser.
import { defineConfig } from '@playwright/test';

const port = Number(process.env.RIPSTIK_TEST_PORT ?? 4199);
const address = `http://127.0.0.1:${port}/lab/`;

// Mesa's llvmpipe draws without a GPU, a third faster over the suite than SwiftShader, which Chromium takes where Mesa is
// missing and RIPSTIK_GL=swiftshader asks for: it draws bit-identically from machine to machine.
const gl =
  process.env.RIPSTIK_GL === 'swiftshader'
    ? ['--use-angle=swiftshader', '--enable-unsafe-swiftshader']
    : ['--use-angle=gl-egl', '--ignore-gpu-blocklist', '--enable-unsafe-swiftshader'];

export default defineConfig({
  testDir: '.',
  testMatch: ['tests/browser/**/*.spec.ts', 'src/features/**/*.spec.ts'],
  outputDir: '.cache/browser-results',
  // Each test has a page of its own and waits for what it needs, never for a time: any two may run beside each other.
  fullyParallel: true,
  workers: 2,
  retries: process.env.CI ? 1 : 0,
  forbidOnly: Boolean(process.env.CI),
  timeout: 180_000, // software WebGL on two cores; no test asserts a time
  expect: { timeout: 30_000 },
  reporter: [['list'], ['json', { outputFile: '.cache/browser.json' }]],
  use: {
    baseURL: address,
    viewport: { width: 1000, height: 640 },
    // The first minute is a visitor's; the tests of it take the flag away.
    storageState: {
      cookies: [],
      origins: [{ origin: new URL(address).origin, localStorage: [{ name: 'ripstik.tour', value: 'seen' }] }],
    },
    deviceScaleFactor: 1,
    locale: 'en-US',
    timezoneId: 'UTC',
    serviceWorkers: 'block', // tests watch the page's own requests; offline.spec.ts allows them
    contextOptions: { reducedMotion: 'reduce' },
    launchOptions: {
      // Empty: the browser that Playwright manages. It adds --no-sandbox itself.
      ...(process.env.RIPSTIK_BROWSER ? { executablePath: process.env.RIPSTIK_BROWSER } : {}),
      env: { ...(process.env as Record<string, string>), LIBGL_ALWAYS_SOFTWARE: '1' },
      args: [
        ...gl,
        '--force-color-profile=srgb',
        '--font-render-hinting=none',
        // Quiet on a closed network.
        '--disable-quic',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-domain-reliability',
        '--no-first-run',
      ],
    },
  },
  webServer: {
    command: `node scripts/serve-dist.mjs --port ${port} --base /lab/`,
    url: address,
    reuseExistingServer: false,
  },
});
