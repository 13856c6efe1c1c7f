import DefaultTheme from 'vitepress/theme-without-fonts';
import 'katex/dist/katex.min.css';
import './style.css';
import Gallery from './Gallery.vue';
import Lessons from './Lessons.vue';
import LivePart from './LivePart.vue';
import QuestionPart from './QuestionPart.vue';

export default {
  extends: DefaultTheme,
  enhanceApp({ app }) {
    if (typeof globalThis.document !== 'undefined') sameTheme();
    for (const [name, part] of Object.entries({ Gallery, Lessons, LivePart, QuestionPart })) app.component(name, part);
  },
};

/** The reference keeps its theme under a name of its own: light here is light there. */
function sameTheme() {
  const { document, localStorage, MutationObserver } = globalThis;
  const root = document.documentElement;
  const keep = () => localStorage.setItem('tsd-theme', root.classList.contains('dark') ? 'dark' : 'light');
  new MutationObserver(keep).observe(root, { attributeFilter: ['class'] });
  keep();
}
