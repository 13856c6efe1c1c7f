/** Descriptions that a person can begin with: every built-in system, and others. Texts are loaded one at a time. */
export interface Template {
  id: string;
  title: string;
  load(): Promise<{ default: string }>;
}

export const templates: readonly Template[] = [
  { id: 'ripstik', title: 'RipStik (caster board)', load: () => import('./templates/ripstik.ts') },
  { id: 'ripstik-rider', title: 'RipStik with a rider', load: () => import('./templates/ripstik-rider.ts') },
  { id: 'caster-rotation', title: 'Caster rotation', load: () => import('./templates/caster-rotation.ts') },
  { id: 'cart-pendulum', title: 'Cart and pendulum', load: () => import('./templates/cart-pendulum.ts') },
  { id: 'rolling-wheel', title: 'Rolling wheel', load: () => import('./templates/rolling-wheel.ts') },
  { id: 'stiff-decay', title: 'Stiff decay (y′ = −15 y)', load: () => import('./templates/stiff-decay.ts') },
  { id: 'wheel-pendulum', title: 'Wheel and pendulum', load: () => import('./templates/wheel-pendulum.ts') },
  { id: 'casterboard-robot', title: 'Casterboard robot', load: () => import('./templates/casterboard-robot.ts') },
  { id: 'bicycle', title: 'Bicycle (Whipple)', load: () => import('./templates/bicycle.ts') },
  { id: 'bicycle-rider', title: 'Bicycle with a leaning rider', load: () => import('./templates/bicycle-rider.ts') },
  { id: 'chaplygin-sleigh', title: 'Chaplygin sleigh', load: () => import('./templates/chaplygin-sleigh.ts') },
  { id: 'torus-disc', title: 'Rolling torus disc', load: () => import('./templates/torus-disc.ts') },
  { id: 'snakeboard', title: 'Snakeboard', load: () => import('./templates/snakeboard.ts') },
  { id: 'twistcar', title: 'Twistcar', load: () => import('./templates/twistcar.ts') },
  {
    id: 'double-pendulum-cart',
    title: 'Double pendulum on a cart',
    load: () => import('./templates/double-pendulum-cart.ts'),
  },
  { id: 'rattleback', title: 'Rattleback', load: () => import('./templates/rattleback.ts') },
];
