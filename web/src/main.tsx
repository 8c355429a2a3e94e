// The dashboard begins here.

import { render } from 'preact';
import { live } from './api/hooks';
import { App } from './app';
import { startTheme } from './ui/theme';
import './styles/base.css';
import './styles/parts.css';
import './styles/pages.css';

startTheme();
live.start();
render(<App />, document.getElementById('app')!);
