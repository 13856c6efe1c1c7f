// npm run --silent ripstik -- <command> …: the command line, src/cli/main.ts, run from its sources.
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { install, main, root } from './setup.mjs';

main(async (args) => {
  await install(console.error); // standard output belongs to the command
  const tsx = pathToFileURL(join(root, 'node_modules/tsx/dist/loader.mjs')).href;
  // npm runs scripts in the package's folder and keeps the person's in INIT_CWD: file names are relative to theirs.
  const cwd = process.env.npm_lifecycle_event === 'ripstik' ? process.env.INIT_CWD : process.cwd();
  const child = spawn(process.execPath, ['--import', tsx, join(root, 'src/cli/main.ts'), ...args], {
    cwd,
    env: { ...process.env, TSX_TSCONFIG_PATH: join(root, 'tsconfig.node.json') },
    stdio: 'inherit',
  });
  // A terminal's Ctrl-C reaches the child itself; it decides, and this process reports how it ended.
  process.on('SIGINT', () => {});
  process.on('SIGTERM', () => child.kill('SIGTERM'));
  return new Promise((done, fail) => {
    child.on('error', fail);
    child.on('close', (code, signal) => done(signal ? 128 + (signal === 'SIGINT' ? 2 : 15) : code));
  });
});
