#include <patchproof/latex/style_file.hpp>

namespace patchproof {

std::string_view style_file() {
  return R"sty(% Written by patchproof; what is changed here is lost when it is run again.
\NeedsTeXFormat{LaTeX2e}
\ProvidesPackage{patchproof}
\RequirePackage{amsmath}
\RequirePackage{amssymb}
\RequirePackage{graphicx}
\RequirePackage{xcolor}
\RequirePackage{tikz}
\RequirePackage[no-math]{fontspec}

\ifdefined\ppbook
  \setlength\oddsidemargin{.4cm}\setlength\evensidemargin{.4cm}\setlength\textwidth{15.2cm}
  \setlength\topmargin{-1cm}\setlength\textheight{24cm}
  \raggedbottom
  % Titles of cases are too long for the head of a page.
  \AtBeginDocument{\renewcommand\sectionmark[1]{}}
  \def\@tocrmarg{4em plus 1fil}
  \def\@pnumwidth{2.4em}
  \renewcommand*\l@section{\@dottedtocline{1}{1.5em}{3em}}
\fi

% Letters: CMU has Cyrillic and all diacritics, and goes with the mathematics.
\IfFontExistsTF{CMU Serif}{\setmainfont{CMU Serif}}{}
\IfFontExistsTF{CMU Sans Serif}{\setsansfont{CMU Sans Serif}}{}
\IfFontExistsTF{CMU Typewriter Text}{\setmonofont{CMU Typewriter Text}}{}

\definecolor{ppgood}{rgb}{0.05,0.38,0.18}
\definecolor{ppbad}{rgb}{0.70,0.08,0.08}
\definecolor{ppopen}{rgb}{0.80,0.40,0.00}
\definecolor{ppquiet}{gray}{0.35}

\newdimen\pp@indent  \pp@indent=1.5em    % of a display
\newdimen\pp@left                        % width of the left side
\newdimen\pp@space                       % for what follows the relation
\newdimen\pp@relation
\newbox\pp@box
\newbox\pp@row
\newbox\pp@piece
\newbox\pp@reason
\newbox\pp@result
\newif\ifpp@first                        % the left side is still to be set
\newif\ifpp@boxed
\newif\ifpp@struck

% ---- headings and text ----
% A new page where less than #1 lines are left.
\newcommand\pp@need[1]{\par\ifdim\pagegoal<\maxdimen
  \ifdim\dimexpr\pagegoal-\pagetotal<#1\baselineskip\newpage\fi\fi}
\newcommand\ppcase[3]{% title, name, sources
  \pp@need{12}\ifdefined\ppbook\section[{#1}]{\raggedright #1}\else\section*{\raggedright #1}\fi
  {\parindent0pt\raggedright\small\texttt{#2}\par #3\par}}
\newcommand\ppsource[1]{\textcolor{ppquiet}{#1}\par}
\newcommand\ppquote[1]{\par{\small\begin{quote}\itshape #1\end{quote}}}
\newcommand\ppheading[1]{\par\addpenalty{-100}\medskip
  {\noindent\textbf{\textsf{#1}}\par}\nobreak\smallskip}
\newcommand\ppclaim[2]{\pp@need{7}\par\addpenalty{-200}\bigskip
  {\noindent\textbf{#1} {\hyphenchar\font=-1 \ppname{#2}}\par}\nobreak\smallskip}
\newcommand\pptext[1]{\par\addvspace{2pt plus 1pt}{\noindent\raggedright #1\par}\nobreak}
\newcommand\ppderivation[2]{\par\addvspace{4pt}{\noindent\raggedright\textit{#1.} #2\par}\nobreak}
\newcommand\ppitem[1]{\par{\raggedright\noindent\hangindent1.5em\hskip1.5em\llap{\textbullet\ }#1\par}}
\newcommand\ppname[1]{{\small\texttt{#1}}}
\newcommand\pplabel[1]{{\footnotesize\texttt{#1}}}
\newcommand\ppverdict[3]{\par\nobreak\smallskip % colour, verdict, evidence
  {\noindent\hbox to\linewidth{\hfil\textcolor{#1}{\rule[-.1ex]{1.2ex}{1.2ex}\enspace
    \textbf{\textsf{#2}}}\small\enspace\textcolor{ppquiet}{#3}}\par}}
\newcommand\ppalarm[2]{\par\smallskip{\noindent\fboxrule1.2pt\fcolorbox{#1}{white}{% colour, text
  \parbox{\dimexpr\linewidth-2\fboxsep-2\fboxrule}{\raggedright #2}}\par}}

% ---- rows ----
% A sum is a list of \pps{summand}: rows are broken between them, and measured.
\newcommand\pps[1]{{}#1}
\newcommand\pp@math[2]{\setbox#1\hbox{$\displaystyle #2$}}
\newcommand\pp@fit[2]{\ifdim\wd#1>#2\setbox#1\hbox{\resizebox{#2}{!}{\box#1}}\fi}
% A rule through a line; from corner to corner through what is tall.
\newcommand\pp@strike[1]{\hbox{\ifdim\dimexpr\ht#1+\dp#1>1.6\baselineskip
    \rlap{\begin{tikzpicture}[baseline=0pt]\draw[ppbad,line width=.7pt](0,-\dp#1)--(\wd#1,\ht#1);%
      \end{tikzpicture}}%
  \else\rlap{\textcolor{ppbad}{\rule[.22em]{\wd#1}{.7pt}}}\fi\unhbox#1}}
\newcommand\pp@sofar{\ifdim\ht\pp@result>0pt\unvbox\pp@result\vskip5pt\fi}
% One finished row: what stands before it, the box with the row.
\newcommand\pp@emit[2]{%
  \setbox\pp@box\hbox{\let\pps\pp@plain#1\box#2}%
  \ifpp@struck\setbox\pp@box\pp@strike\pp@box\fi
  \ifpp@boxed
    \global\setbox\pp@result\vbox{\pp@sofar
      \hbox{\box\pp@box\ifdim\wd\pp@reason>0pt\hskip2em\unhbox\pp@reason\fi}}%
  \else
    \par\noindent\hbox to\linewidth{\hskip\pp@indent\box\pp@box\hfil\unhbox\pp@reason}\par
  \fi}
\newcommand\pp@skips{\lineskiplimit2pt\lineskip4pt\baselineskip1.35\normalbaselineskip\relax}
% Fills rows of width #1 with \pp@content; a row is set behind \pp@before, later ones behind
% \pp@behind. The last row stays in \pp@row.
\newcommand\pp@fill[1]{%
  \pp@math\pp@row\pp@content
  \pp@dimen=\dimexpr#1\relax
  \ifdim\wd\pp@row>\pp@dimen
    \expandafter\in@\expandafter{\expandafter\pps\expandafter}\expandafter{\pp@content}%
    \ifin@
      \setbox\pp@row\hbox{}%
      \let\pps\pp@add\pp@content\let\pps\pp@plain
    \else
      \pp@fit\pp@row\pp@dimen
    \fi
  \fi}
\newdimen\pp@dimen
\newdimen\pp@later                       % the width of all rows but the first
\let\pp@plain\pps
\newcommand\pp@add[1]{%
  \pp@math\pp@piece{{}#1}\pp@fit\pp@piece\pp@dimen
  \ifdim\dimexpr\wd\pp@row+\wd\pp@piece>\pp@dimen
    \ifdim\wd\pp@row>0pt \pp@emit{\pp@before}\pp@row \let\pp@before\pp@behind\pp@dimen=\pp@later\fi
    \setbox\pp@row\hbox{}%
  \fi
  \setbox\pp@row\hbox{\unhbox\pp@row\unhbox\pp@piece}}
% The reason of a step: at the right of its last row, or on a line of its own below it.
\newcommand\pp@withreason[1]{%
  \setbox\pp@reason\hbox{\small\textcolor{ppquiet}{#1}}%
  \ifdim\dimexpr\pp@indent+\pp@left+\pp@relation+\wd\pp@row+\wd\pp@reason+1.5em>\linewidth
    \setbox\pp@piece\vbox{\hsize.8\linewidth\raggedleft\parindent0pt\small
      \textcolor{ppquiet}{#1}\par}%
    \setbox\pp@reason\hbox{}%
    \pp@emit{\pp@before}\pp@row
    \ifpp@boxed\global\setbox\pp@result\vbox{\pp@sofar\box\pp@piece}%
    \else\par\nobreak\noindent\hbox to\linewidth{\hfil\box\pp@piece}\par\fi
  \else
    \pp@emit{\pp@before}\pp@row
  \fi}

% start = a = b: \begin{ppchain}{start} \ppline{=}{a}{reason} ... \end{ppchain}
\newenvironment{ppchain}[1]{%
  \par\addvspace{3pt plus 1pt}\pp@skips\parindent0pt\parskip0pt
  \setbox\pp@reason\hbox{}%
  \pp@math\pp@box{#1}\pp@left=\wd\pp@box
  \def\pp@leftside{#1}\pp@firsttrue
}{\par\addvspace{3pt plus 1pt}}
\newcommand\ppline[3]{%
  \pp@math\pp@piece{{}#1{}}\pp@relation=\wd\pp@piece
  \ifpp@first\pp@placeleft{#2}\fi
  \pp@space=\dimexpr\linewidth-\pp@indent-\pp@left-\pp@relation-1.2em\relax
  \ifpp@boxed\advance\pp@space-10pt\advance\pp@space-2em\fi
  \ifpp@first
    \def\pp@before{\hbox to\pp@left{$\displaystyle\pp@leftside$\hfil}$\displaystyle{}#1{}$}%
  \else
    \def\pp@before{\hskip\pp@left$\displaystyle{}#1{}$}%
  \fi
  \def\pp@behind{\hskip\pp@left\hskip\pp@relation\hskip1.2em}%
  \def\pp@content{#2}\pp@later=\pp@space\pp@fill\pp@space\pp@withreason{#3}%
  \pp@firstfalse}
% A left side that takes more than a third of the line has a row of its own, unless the first row
% has room for both sides.
\newcommand\pp@placeleft[1]{%
  \pp@math\pp@row{#1}%
  \ifdim\pp@left>.34\linewidth
    \ifdim\dimexpr\pp@left+\wd\pp@row+\pp@relation+2\pp@indent+4em>\linewidth
      \pp@space=\dimexpr\linewidth-2\pp@indent\relax
      \def\pp@before{}\def\pp@behind{\hskip1.2em}%
      \let\pp@content\pp@leftside\pp@later=\dimexpr\pp@space-1.2em-2\fboxsep\relax
      \pp@fill{\pp@space-1.2em-2\fboxsep}\pp@emit{\pp@before}\pp@row
      \nobreak
      \pp@left=1.2em \pp@firstfalse
    \fi
  \fi}
% Mathematics without a relation.
\newcommand\ppalone[1]{\par\addvspace{2pt}{\pp@skips\parindent0pt\setbox\pp@reason\hbox{}%
  \def\pp@before{}\def\pp@behind{\hskip1.2em}%
  \def\pp@content{#1}\pp@later=\dimexpr\linewidth-2\pp@indent-1.2em-2\fboxsep\relax
  \pp@fill\pp@later\pp@emit{\pp@before}\pp@row\par}}

% A side of a statement in words, and its value.
\newcommand\ppside[2]{\par{\pp@indent0pt\lineskiplimit2pt\lineskip4pt\parindent0pt\setbox\pp@reason\hbox{}%
  \def\pp@before{\hbox{#1:\enspace}}\def\pp@behind{\hskip3em}\setbox\pp@piece\hbox{#1:\enspace}%
  \def\pp@content{#2}\pp@later=\dimexpr\linewidth-4em\relax
  \pp@fill{\linewidth-\wd\pp@piece-1em}\pp@emit{\pp@before}\pp@row\par}}

% A result: its chains in a box, or, where that is more than half a page, without one.
\newenvironment{ppresult}{\par\addvspace{4pt}\pp@boxedtrue\global\setbox\pp@result\vbox{}%
}{\pp@boxedfalse\par\nobreak
  \ifdim\dimexpr\ht\pp@result+\dp\pp@result>.5\textheight
    \unvbox\pp@result
  \else
    \noindent\hbox to\linewidth{\hskip\pp@indent\fboxsep5pt\kern-\fboxsep\fbox{\box\pp@result}\hfil}%
  \fi\par\addvspace{4pt}}
% What a book prints and is false: a line through every row.
\newenvironment{ppstruck}{\pp@strucktrue}{\par}

% ---- book ----
\newcommand\pptitle[2]{\begin{titlepage}\vspace*{.25\textheight}\begin{center}
  {\Huge\bfseries\sffamily #1\par}\vspace{3em}{\large #2\par}\end{center}\end{titlepage}}
\newenvironment{pptable}[1]{\par\medskip\noindent\small
  \begin{lrbox}{\pp@result}\begin{tabular}{@{}#1@{}}}%
  {\end{tabular}\end{lrbox}\pp@fit\pp@result\linewidth\box\pp@result\par}

\newcommand\ppfigure[2]{\par\medskip\noindent\hbox to\linewidth{\hfil\setbox\pp@box\hbox{#1}%
  \pp@fit\pp@box\linewidth\box\pp@box\hfil}\par\nobreak
  {\centering\footnotesize #2\par}\medskip}
\endinput
)sty";
}

}  // namespace patchproof
