// One block of a Fagor 8055 program (8055 T 2, 11 and 12). The tokens come from our own
// scanner by way of the shape key: a word is a letter and a value, a G code is any G code, a variable is any variable. What
// they mean, and which of them the control has, stands in its tables; no number and no name is written here.
//
// Every decision is LL(1): the next token decides. So the generated parser never predicts, its cost does not depend on
// what it has seen before, and an error is found at the first token that fits no block (the build checks this).
parser grammar Fagor8055;

tokens {
    // ISO blocks. G_CALL: a G code that calls a subroutine with arguments.
    SKIP_MARK, G_CODE, G_CALL, M_CODE, LETTER, LETTER_N, LETTER_P,
    NUMBER, TEXT, LEFT, RIGHT, COMMA, EQUALS, PLUS, MINUS, TIMES, DIVIDE, OTHER,
    // operators and operands. The kinds of variable differ by their index: none, an entry number, an entry number that
    // may be left out, a label and a program.
    FUNCTION, RELATION, NOT, AND, OR, XOR, EXP, MOD, ARG, PI, VARIABLE, INDEXED_VARIABLE, TABLE_VARIABLE, POSITION_VARIABLE,
    // statements
    IF, ELSE, GOTO, RPT, SUB, CALL, EXEC, OPEN, DEVICE, ONE_TEXT, ERROR, OPERANDS, ALONE, REPOS,
    IB, INPUT, WINDOW, SK, WBUF
}

block : marks+=SKIP_MARK* numbered=label? ( words=iso | LEFT body=statement RIGHT times=repetition? )? EOF ;

label      : LETTER_N value ;
repetition : LETTER_N value ;

// ---- ISO

// N after another word is the repetition or an operand (G41 N): the binder knows.
iso  : call | word ( word | count )* call? ;
word : code=( G_CODE | M_CODE ) | letter=LETTER amount=value? ;
count : LETTER_N amount=value? ;

call     : G_CALL argument* repetition? ;
argument : code=( G_CODE | M_CODE )
         | letter=LETTER EQUALS? amount=value
         | parameter=LETTER_P number=NUMBER? EQUALS amount=value ;

value : number=NUMBER | sign=( PLUS | MINUS )? parameter=LETTER_P number=NUMBER ;

// ---- statements

statement : branch | definition | action ;

branch : IF condition=expression then=action? ( alternative=ELSE otherwise=action? )? ;

definition : SUB NUMBER ;

action : assignments | jump | repeat | subroutine | execute | open | text | error | operands | reposition | entry
       | windows | softkeys | buffer | alone ;

assignments : assignment ( COMMA assignment )* ;
assignment  : letter=( LETTER | LETTER_N ) ( EQUALS result=expression | sign=( PLUS | MINUS )? constant=NUMBER )
            | letter=LETTER_P ( number=NUMBER | LEFT number_of=expression RIGHT )? EQUALS result=expression
            | target=variable EQUALS result=expression ;

jump       : GOTO LETTER_N reference ;
repeat     : RPT LETTER_N first=reference COMMA LETTER_N last=reference ( COMMA in=program )? ;
subroutine : CALL expression ( COMMA assignment )* ;
execute    : EXEC program ( COMMA device )? ;
open       : OPEN program ( COMMA option )* ;
text       : ONE_TEXT TEXT? ;
error      : ERROR ( message=TEXT | number=expression ( COMMA message=TEXT )? )? ;
operands   : OPERANDS expression ( COMMA expression )* ;
reposition : REPOS name ( COMMA name )* ;
alone      : ALONE ;

program   : LETTER_P reference ;
reference : NUMBER | LEFT expression RIGHT ;
option    : where=device | comment=TEXT ;
device    : DEVICE | name+ ;
name      : LETTER | LETTER_N | LETTER_P ;

// customisation programs
entry    : IB index EQUALS INPUT TEXT ( COMMA expression )? ;
windows  : window ( COMMA window )* ;
window   : WINDOW index EQUALS expression ;
softkeys : softkey ( COMMA softkey )* ;
softkey  : SK index EQUALS TEXT ;
buffer   : WBUF ( TEXT ( COMMA expression )? )? ;

index : NUMBER | LETTER_P NUMBER | LEFT expression RIGHT ;

// ---- expressions, from the weakest operator to the strongest (8055 T 11.5.1)

expression  : conjunction ( OR conjunction )* ;
conjunction : comparison ( ( AND | XOR ) comparison )* ;
comparison  : sum ( RELATION sum )* ;
sum         : product ( ( PLUS | MINUS ) product )* ;
product     : power ( ( TIMES | DIVIDE ) power )* ;
power       : unary ( ( EXP | MOD ) unary )* ;
unary       : ( NOT | PLUS | MINUS | FUNCTION )* primary ;
primary     : NUMBER
            | PI
            | LETTER
            | LETTER_P ( NUMBER | LEFT expression RIGHT )?
            | variable
            | IB index
            | ARG LEFT expression COMMA expression RIGHT
            | LEFT expression RIGHT ;

variable : VARIABLE
         | INDEXED_VARIABLE index
         | TABLE_VARIABLE reference?
         | POSITION_VARIABLE LETTER_N reference LETTER_P reference ;
