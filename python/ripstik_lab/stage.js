// Shows a stage: the page that the package brings, in a frame of its own, and the messages between it and what is around it.
// As a module by itself this is the widget's; an exported page has it in a script, where `show` is called by hand.

/** Text of gzipped bytes. */
const unpacked = (bytes) =>
  new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();

/** Whether the notebook around is dark, as far as it says so. */
const darkNotebook = () =>
  document.body.dataset.jpThemeLight === 'false' || document.body.dataset.vscodeThemeKind === 'vscode-dark';

/**
 * @param place element that it fills
 * @param page gzipped text of the page
 * @param first gzipped JSON of what it is told when it is ready
 * @param theme `light`, `dark` or empty: as the notebook
 * @param hear what is called with each message of the page
 * @returns how to speak to it, and how to end
 */
async function show(place, page, first, { theme, height }, hear = () => {}) {
  const [html, messages] = await Promise.all([unpacked(page), unpacked(first).then(JSON.parse)]);
  const frame = document.createElement('iframe');
  const refused = document.createElement('p');
  refused.setAttribute('role', 'alert');
  refused.style.cssText =
    'position: absolute; top: 48px; left: 16px; right: 16px; margin: 0; font: 14px sans-serif; color: #b3261e; background: #fff';
  const say = (message) => frame.contentWindow?.postMessage({ ripstik: 1, ...message }, '*');
  const listen = ({ source, data }) => {
    if (source !== frame.contentWindow || data?.ripstik !== 1) return;
    if (data.type === 'ready') messages.forEach(say);
    if (data.type === 'error') refused.textContent = data.message;
    hear(data);
  };
  addEventListener('message', listen);
  // A frame of no origin: it can reach neither the notebook nor what the browser keeps for it.
  frame.sandbox = 'allow-scripts allow-downloads';
  frame.allow = 'fullscreen';
  frame.title = 'RipStik Lab';
  frame.style.cssText = `display: block; width: 100%; height: ${height}; border: 0`;
  const dark = theme ? theme === 'dark' : darkNotebook();
  frame.srcdoc = html.replace('data-theme="light"', `data-theme="${dark ? 'dark' : 'light'}"`);
  place.style.position = 'relative';
  place.replaceChildren(frame, refused);
  const speak = (message) => {
    refused.textContent = '';
    say(message);
  };
  return { say: speak, end: () => removeEventListener('message', listen) };
}

export default {
  async render({ model, el }) {
    const pageModel = await model.widget_manager.get_model(model.get('page').replace('IPY_MODEL_', ''));
    const look = { theme: model.get('theme'), height: `${model.get('height')}px` };
    const { say, end } = await show(el, pageModel.get('packed'), model.get('first'), look, (data) => model.send(data));
    model.on('msg:custom', say);
    return () => {
      model.off('msg:custom', say);
      end();
    };
  },
};
