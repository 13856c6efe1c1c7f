/** Colours of the scene. Front orange and back blue are a pair that colour-blind people tell apart (Okabe and Ito). */
export interface Palette {
  background: string;
  ground: string;
  fineLine: string;
  strongLine: string;
  label: string;
  front: string;
  back: string;
  board: string;
  sky: string;
  bounce: string;
  shadow: number;
  exposure: number;
}

export const palettes: Readonly<Record<'light' | 'dark', Palette>> = {
  light: {
    background: '#eceef1', ground: '#e2e5e9', fineLine: '#c9ced6', strongLine: '#a3abb7', label: '#5b6472',
    front: '#d55e00', back: '#0072b2', board: '#5b6472', sky: '#ffffff', bounce: '#b9b4ac', shadow: 0.3, exposure: 1.0,
  },
  dark: {
    background: '#14171c', ground: '#1b1f26', fineLine: '#2a303a', strongLine: '#434c5a', label: '#8d98a8',
    front: '#f0a030', back: '#56b4e9', board: '#9aa5b5', sky: '#dfe8f5', bounce: '#747c8a', shadow: 0.55, exposure: 1.05,
  },
};
