// npm start: installs what is missing, builds what is stale, serves the page, opens the browser where there is one.
import { spawn } from 'node:child_process';
import { serve } from './serve-dist.mjs';
import { Plain, build, built, install, main } from './setup.mjs';

const USAGE = `npm start [-- --port N] [--no-open]
  --port N   first port to try (4173); the next free one is taken when it is busy
  --no-open  do not open a browser`;

function options(args) {
  const chosen = { port: 4173, open: true, help: false };
  for (let i = 0; i < args.length; i++) {
    const [name, inline] = args[i].split('=');
    if (name === '--port') {
      const text = inline === undefined ? args[++i] : inline;
      chosen.port = Number(text);
      if (!/^\d+$/.test(text) || chosen.port < 1 || chosen.port > 65535) {
        throw new Plain(`--port takes a number from 1 to 65535, not ${text === undefined ? 'nothing' : `'${text}'`}.`);
      }
    } else if (name === '--no-open') chosen.open = false;
    else if (name === '--help' || name === '-h') chosen.help = true;
    else throw new Plain(`Unknown option '${args[i]}'.\n${USAGE}`);
  }
  return chosen;
}

/** Opens the address in the person's browser; where that does not work the printed address is enough. */
function openBrowser(address) {
  const env = process.env;
  if (env.CI || env.BROWSER === 'none') return;
  let command = ['xdg-open', address];
  if (process.platform === 'darwin') command = ['open', address];
  else if (process.platform === 'win32') command = ['cmd', '/c', 'start', '', address];
  else if (env.WSL_DISTRO_NAME) command = ['cmd.exe', '/c', 'start', '', address];
  else if (!env.DISPLAY && !env.WAYLAND_DISPLAY) return;
  const child = spawn(command[0], command.slice(1), { stdio: 'ignore', detached: true });
  child.on('error', () => {});
  child.unref();
}

main(async (args) => {
  const { port, open, help } = options(args);
  if (help) {
    console.log(USAGE);
    return;
  }
  await install();
  if (!built()) {
    console.log('Building the page …');
    if (!(await build())) throw new Plain('The build failed; what is wrong stands above.');
  }
  const served = await serve({ port });
  if (served.port !== port) console.log(`Port ${port} is busy; using ${served.port}.`);
  const address = `http://127.0.0.1:${served.port}/`;
  console.log(`RipStik Lab is at ${address} (Ctrl-C stops it)`);
  const stop = () => {
    served.server.close();
    served.server.closeAllConnections();
  };
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.once(signal, stop);
  if (open) openBrowser(address);
});
